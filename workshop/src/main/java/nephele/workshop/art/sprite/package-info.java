/** Painters of billboards (plants with alpha, atlases of mist, smoke and fire), of clouds seen from above, and of a grid of densities. */
package nephele.workshop.art.sprite;
