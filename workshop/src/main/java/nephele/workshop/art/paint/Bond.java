package nephele.workshop.art.paint;

/**
 * A pattern of rectangular pieces in rows over a tile: bricks, slabs, planks, panels.
 *
 * @param tileMetres side of the square tile; an integer number of pieces fits in it
 * @param shift offset of each row from the row below, as a fraction of a piece's width
 */
public record Bond(double tileMetres, int columns, int rows, double shift) {
    /**
     * The piece at a point.
     *
     * @param x offset from the piece's centre in metres, to the right
     * @param y offset from the piece's centre in metres, upwards
     * @param edge distance to the nearest side in metres
     */
    public record Piece(int column, int row, double x, double y, double edge) {
        /** Returns a random number 0–1 that is constant over the piece. */
        public double random(int seed) {
            return TileNoise.random(column, row, seed);
        }
    }

    public Piece at(double x, double y) {
        double width = tileMetres / columns;
        double height = tileMetres / rows;
        int row = (int) Math.floor(y / height);
        double along = x / width + shift * row;
        int column = (int) Math.floor(along);
        double localX = (along - column - 0.5) * width;
        double localY = y - (row + 0.5) * height;
        double edge = Math.min(width / 2 - Math.abs(localX), height / 2 - Math.abs(localY));
        return new Piece(Math.floorMod(column, columns), Math.floorMod(row, rows), localX, localY, edge);
    }
}
