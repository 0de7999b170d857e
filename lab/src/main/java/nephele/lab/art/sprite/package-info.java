/** Painters of billboards: plants with alpha, and atlases of mist, smoke and fire. */
package nephele.lab.art.sprite;
