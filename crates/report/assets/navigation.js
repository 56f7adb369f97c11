"use strict";
// The list of sections: which one is being read, and that there is more of the list where it does not fit.

const bar = document.querySelector(".bar nav");

/** Marks the sides on which the list goes on. */
function markMore() {
  const end = bar.scrollWidth - bar.clientWidth - bar.scrollLeft;
  bar.classList.toggle("more-before", bar.scrollLeft > 2);
  bar.classList.toggle("more-after", end > 2);
}
bar.addEventListener("scroll", markMore, { passive: true });

const seen = new IntersectionObserver(
  (entries) => {
    for (const entry of entries) {
      const link = document.querySelector(`.bar a[href="#${entry.target.id}"]`);
      if (entry.isIntersecting) {
        link?.setAttribute("aria-current", "true");
        // The section that is read is shown in the list; the page itself stays where it is.
        if (link) bar.scrollTo({ left: link.offsetLeft - bar.offsetLeft - (bar.clientWidth - link.offsetWidth) / 2 });
      } else link?.removeAttribute("aria-current");
    }
  },
  { rootMargin: "-40% 0px -59% 0px" },
);

// Not before the page is there: it would have to be laid out for this. Letters that come later make the list longer.
addEventListener("load", () => {
  const sizes = new ResizeObserver(markMore);
  for (const part of [bar, ...bar.children]) sizes.observe(part);
  document.querySelectorAll("main > section").forEach((section) => seen.observe(section));
});
