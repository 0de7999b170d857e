/**
 * A traced picture in tiles: {@link nephele.engine.reference.tile.PixelTiles} divides it, {@link
 * nephele.engine.reference.tile.PartFile} keeps finished tiles on disk, so that a picture can be interrupted or divided
 * among machines, and {@link nephele.engine.reference.tile.MergedParts} puts it together again.
 */
package nephele.engine.reference.tile;
