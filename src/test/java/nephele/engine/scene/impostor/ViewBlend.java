package nephele.engine.scene.impostor;

import nephele.engine.math.Vec3;

/**
 * The three views of an atlas that are nearest to a direction, with their weights: the corners of a triangle of the grid,
 * weighted so that they change continuously. The twin of {@code impostor-views.glsl}.
 *
 * @param views column + side · row of each
 * @param weights at least 0; their sum is 1
 */
record ViewBlend(int[] views, double[] weights) {
    /** @param side views along a side of the grid */
    static ViewBlend of(Vec3 direction, int side) {
        double x = (0.5 + 0.5 * AtlasView.u(direction)) * (side - 1);
        double y = (0.5 + 0.5 * AtlasView.v(direction)) * (side - 1);
        int column = Math.min((int) Math.floor(x), side - 2);
        int row = Math.min((int) Math.floor(y), side - 2);
        double right = x - column;
        double up = y - row;
        int first = column + side * row;
        int second = right > up ? first + 1 : first + side;
        return new ViewBlend(
                new int[] {first, second, first + 1 + side},
                new double[] {1 - Math.max(right, up), Math.abs(right - up), Math.min(right, up)});
    }
}
