// SPDX-License-Identifier: MIT
import './style/base.css';
import './style/editor.css';
import './style/job.css';
import { editorPage } from './editor/editor_page';
import { jobListPage } from './jobs/job_list_page';
import { jobPage } from './jobs/job_page';
import { h } from './ui/dom';
import type { Page } from './ui/page';
import { startTheme, themeChoice } from './ui/theme';

const links: readonly [string, string][] = [['#/new', 'New'], ['#/jobs', 'Jobs']];

function pageOf(hash: string): Page {
  const job = /^#\/jobs\/([A-Za-z0-9_.-]+)$/.exec(hash);
  if (job) return jobPage(job[1]);
  const copy = /^#\/new\/([A-Za-z0-9_.-]+)$/.exec(hash);
  if (copy) return editorPage(copy[1]);
  if (hash === '#/jobs') return jobListPage();
  return editorPage();
}

function start(): void {
  startTheme();
  const main = h('main', { id: 'main', tabindex: -1 });
  const navigation = h('nav', { 'aria-label': 'Pages' }, ...links.map(([href, text]) => h('a', { href }, text)));
  const header = h('header', { class: 'site' }, h('a', { class: 'brand', href: '#/new' }, 'Slipstitch'), navigation, themeChoice());
  document.body.append(h('a', { class: 'skip', href: '#main', onclick: (event: Event) => {
    event.preventDefault();
    main.focus();
  } }, 'Skip to content'), header, main);

  let page: Page | undefined;
  const route = (): void => {
    page?.leave();
    const hash = location.hash || '#/new';
    page = pageOf(hash);
    document.title = `${page.title} – Slipstitch`;
    main.replaceChildren(page.element);
    for (const link of navigation.querySelectorAll('a')) {
      if (hash.startsWith(link.getAttribute('href') ?? '')) link.setAttribute('aria-current', 'page');
      else link.removeAttribute('aria-current');
    }
  };
  window.addEventListener('hashchange', route);
  route();
}

start();
