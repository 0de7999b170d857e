/**
 * The level as the author wrote it: immutable records, one to one with the JSON file. {@code level.json} reads and
 * writes them, {@code rule} checks them, {@code level.placed} derives shapes in the world, {@code
 * level.appearance} tells what materials, lights and skies mean.
 */
package nephele.engine.level;
