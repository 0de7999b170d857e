/** Painters of billboards: plants with alpha, and atlases of mist, smoke and fire. */
package nephele.workshop.art.sprite;
