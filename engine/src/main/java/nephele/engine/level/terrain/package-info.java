/** Terrains of a level: the height field of a height map, and how the layers of materials mix on it. */
package nephele.engine.level.terrain;
