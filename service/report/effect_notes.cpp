// SPDX-License-Identifier: MIT
#include "report/effect_notes.h"

#include <array>

#include "model/effect_list.h"

namespace slipstitch {
namespace {

struct Note {
  std::string_view effect, text;
};

constexpr std::array kNotes{
    Note{
        "inertia",
        "The mass of the yarn, spread along it and carried by it as it slides. You need it for everything that swings, "
        "falls or is hit. It costs little itself, a 14-coordinate block a segment, but a moving scene takes as many "
        "steps as its motion asks for. Without it every step is a static equilibrium: right for relaxed shapes and "
        "slow "
        "pulls, wrong for anything whose speed matters."},
    Note{"gravity",
         "The weight of the yarn. You need it wherever the fabric hangs, falls or lies. It costs a linear energy a "
         "segment, which is next to nothing. Without it nothing drapes."},
    Note{"stretch",
         "The yarn's resistance to extension, EA. Every scene needs it. Without it yarn has no length, and a scene "
         "of any size collapses or cannot be solved at all. It costs one block a segment, and its stiffness is what "
         "makes "
         "large time steps hard."},
    Note{"bending",
         "The yarn's resistance to bending, EI, at every node. You need it wherever loops have a "
         "shape and fabric a hand; the repeat of a knit is relaxed with it. It costs a block of three nodes a bend. "
         "Without it loops fold up under any load "
         "and there are no relaxed dimensions."},
    Note{
        "bending_jamming",
        "Bending that stiffens, up to a thousandfold, where yarn curls tighter than the loop it rests in. You need it "
        "where loops close under tension. It costs a second evaluation of every bend. Without it heads and sinkers can "
        "collapse to kinks that real yarn, which has a thickness, cannot form."},
    Note{"wrapping",
         "The torque with which two interlaced loops keep wrapped around each other, with its sign from knit or purl. "
         "It is why stockinette curls and ribs draw in, so every knit needs it. It costs two blocks of four nodes a "
         "stitch contact. Without it the fabric lies as a flat net, rib is as wide as stockinette, and nothing keeps "
         "contacts from turning over."},
    Note{"sliding",
         "Yarn that moves along itself through its contacts, as arc lengths that are unknowns. You need it for pulls, "
         "snags, pulled-out ends and for how evenly a fabric shares its load. It costs two more unknowns at every "
         "contact "
         "node, and makes matrix and factor larger accordingly. Without it yarn is glued where it crosses: the fabric "
         "is "
         "too stiff and never changes its loops."},
    Note{"contact_length",
         "Keeps the length of yarn inside a stitch contact near its rest length while the yarn slides. A sliding knit "
         "needs it. It costs a two-coordinate block a contact and yarn. Without it contacts open or close along the "
         "yarn until one is empty."},
    Note{
        "parallel_contact",
        "Keeps neighbouring contacts of one yarn at least about a yarn's diameter apart, with a barrier below half of "
        "that. A sliding knit under load needs it. It costs a two-coordinate block a free segment. Without it contacts "
        "slide into one another and the run stops at the limit of an empty segment."},
    Note{
        "sliding_friction",
        "Coulomb stick-slip between the yarns of a contact, from the normal force that their tension and bending press "
        "there. You need it for the loss in a stretch cycle, for what stays deformed, and for snags that hold. It "
        "costs a one-coordinate spring a sliding arc length and the estimate of the normal forces once a step. Without "
        "it yarn runs freely and a pulled loop empties its neighbours."},
    Note{
        "damping",
        "Viscous loss in stretch, bending and wrapping rates, and in sliding; rigid motion is not damped. You need it "
        "to come to rest in a natural time. It costs one more evaluation for each kind that has a coefficient. Without "
        "it only friction, air and the time steps take energy, and a swatch swings for long; in a static scene it only "
        "steadies the way to rest."},
    Note{"colliders",
         "Planes, spheres, capsules, boxes and closed meshes that yarn touches but does not enter, fixed, moving or, "
         "for "
         "a sphere, pushed by the yarn, with friction. You need them for whatever the fabric lies on or is worn over. "
         "They cost a distance a yarn point and step, and blocks only where something touches. Without them the fabric "
         "falls through."},
    Note{
        "self_collision",
        "Contact between parts of the fabric that are not neighbours: folds, scrolls, layers. You need it where fabric "
        "meets itself. It costs most of all: a search for close pairs whenever the yarn moves, and new matrix "
        "entries where layers meet. Without it fabric passes through itself, which is harmless as long as it does not "
        "fold."},
    Note{"air_drag",
         "Drag of still air on every segment, linear and quadratic in its speed. You need it for light fabric that "
         "flutters or falls far. It costs a block a segment. Without it swatches fall and swing as in a vacuum; up to "
         "about a metre a second and over short times that is hard to see."},
    Note{"wind",
         "Air that moves, steadily and in gusts; the drag is against it. You need it where wind is what moves the "
         "fabric. "
         "It costs nothing beyond the drag. Without it the air stands still."},
    Note{"shrinkage",
         "Rest lengths that change in time, as in blocking and fulling. You need it for finishing. It costs nothing: "
         "stretch is measured against another length. Without it the yarn keeps the length it was knitted with."},
    Note{"plasticity",
         "Bends that keep a set: a rest angle that creeps after the bend angle beyond a yield angle. You need it for "
         "yarn that remembers its loops when unravelled, and for creases. It costs a number a bend. Without it all "
         "deformation that friction does not hold springs back. The set has a size but no direction: the plane of a "
         "bend "
         "is free."},
};

}  // namespace

std::string_view effect_note(std::string_view effect) {
  for (const Note& note : kNotes)
    if (note.effect == effect) return note.text;
  return {};
}

std::string_view handles_note() {
  return "Not an effect but part of a scene: nodes whose place is prescribed, held, moved at a velocity or along "
         "keyframes, "
         "and dead loads. You need handles to hold or to stretch fabric; a clamp that pulls is a handle with "
         "keyframes, and "
         "the force that it takes is measured at every step (summary and reactions.csv). They cost nothing, as held "
         "coordinates are no unknowns; measuring costs one gradient of the stencils at the handles a step. Without any "
         "a "
         "fabric is free.";
}

std::string effect_notes_markdown() {
  std::string text = "## The effects\n\n";
  for (const EffectEntry& effect : effect_list()) {
    text += std::string("**") + effect.name + "**. " + std::string(effect_note(effect.name)) + "\n\n";
  }
  return text + "**handles and loads**. " + std::string(handles_note()) + "\n";
}

}  // namespace slipstitch
