package nephele.lab.trade.subject;

import java.nio.ByteBuffer;

/** The pixels at edges between surfaces, found in a picture in which every surface has a colour of its own. */
final class IdEdges {
    private IdEdges() {}

    /**
     * Returns for each pixel whether one of the eight around it shows another surface.
     *
     * @param rgba the colours, row by row
     */
    static boolean[] near(ByteBuffer rgba, int width, int height) {
        boolean[] near = new boolean[width * height];
        for (int i = 0; i < near.length; i++) {
            int column = i % width;
            int row = i / width;
            for (int y = Math.max(row - 1, 0); y <= Math.min(row + 1, height - 1); y++) {
                for (int x = Math.max(column - 1, 0); x <= Math.min(column + 1, width - 1); x++) {
                    near[i] |= rgba.getInt(4 * (y * width + x)) != rgba.getInt(4 * i);
                }
            }
        }
        return near;
    }
}
