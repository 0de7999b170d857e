/** The height map and the maps of growth of the level "Standing stones". */
package nephele.workshop.art.terrain;
