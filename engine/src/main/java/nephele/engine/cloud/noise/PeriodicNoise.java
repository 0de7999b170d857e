package nephele.engine.cloud.noise;

import nephele.engine.math.SeededNoise;

/**
 * Gradient and cellular noise that repeat after a whole number of cells, evaluated at the points of a cube, or at those
 * of one layer through the middle of cells.
 */
final class PeriodicNoise {
    private static final int[][] GRADIENTS = {
        {1, 1, 0}, {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}, {1, 0, 1}, {-1, 0, 1},
        {1, 0, -1}, {-1, 0, -1}, {0, 1, 1}, {0, -1, 1}, {0, 1, -1}, {0, -1, -1}
    };

    private final int size;
    private final int layers;
    private final SeededNoise hash;

    /**
     * @param size points along x and along z
     * @param layers points along y: 1 or the size
     */
    PeriodicNoise(int size, int layers, int seed) {
        this.size = size;
        this.layers = layers;
        hash = new SeededNoise(seed);
    }

    /**
     * Adds gradient noise (Perlin 2002, "Improving Noise"), about −1 to 1.
     *
     * @param cells along an edge; a divisor of the size
     */
    void addGradient(float[] sum, int cells, float weight) {
        float[] fade = new float[size / cells];
        for (int i = 0; i < fade.length; i++) {
            fade[i] = fade((i + 0.5f) / fade.length);
        }
        int cellsUp = cellsUp(cells);
        for (int k = 0; k < cells; k++) {
            for (int j = 0; j < cellsUp; j++) {
                for (int i = 0; i < cells; i++) {
                    addGradientCell(sum, cells, weight, fade, new int[] {i, j, k});
                }
            }
        }
    }

    private int cellsUp(int cells) {
        return layers == 1 ? 1 : cells;
    }

    private static float fade(float t) {
        return t * t * t * (t * (t * 6 - 15) + 10);
    }

    private void addGradientCell(float[] sum, int cells, float weight, float[] fade, int[] cell) {
        int points = fade.length;
        int cellsUp = cellsUp(cells);
        int pointsUp = layers / cellsUp;
        int[][] corner = new int[8][];
        for (int c = 0; c < 8; c++) {
            int bits = hash.bits(
                    (cell[0] + (c & 1)) % cells, (cell[1] + (c >> 1 & 1)) % cellsUp, (cell[2] + (c >> 2)) % cells);
            corner[c] = GRADIENTS[(bits >>> 1) % GRADIENTS.length];
        }
        for (int k = 0; k < points; k++) {
            float z = (k + 0.5f) / points;
            for (int j = 0; j < pointsUp; j++) {
                float y = (j + 0.5f) / pointsUp;
                float v = fade(y);
                int at = ((cell[2] * points + k) * layers + cell[1] * pointsUp + j) * size + cell[0] * points;
                for (int i = 0; i < points; i++) {
                    float x = (i + 0.5f) / points;
                    float u = fade[i];
                    float lower =
                            mix(edge(corner[0], corner[1], x, y, z, u), edge(corner[2], corner[3], x, y - 1, z, u), v);
                    float upper = mix(
                            edge(corner[4], corner[5], x, y, z - 1, u),
                            edge(corner[6], corner[7], x, y - 1, z - 1, u),
                            v);
                    sum[at + i] += weight * mix(lower, upper, fade[k]);
                }
            }
        }
    }

    private static float edge(int[] left, int[] right, float x, float y, float z, float fraction) {
        return mix(left[0] * x + left[1] * y + left[2] * z, right[0] * (x - 1) + right[1] * y + right[2] * z, fraction);
    }

    private static float mix(float a, float b, float fraction) {
        return a + (b - a) * fraction;
    }

    /**
     * Adds the distance to the nearest of one random point a cell, in cells and at most 1 (Worley 1996, "A Cellular
     * Texture Basis Function").
     *
     * @param cells along an edge; a divisor of the size
     */
    void addCellular(float[] sum, int cells, float weight) {
        float[] points = points(cells);
        int perCell = size / cells;
        int cellsUp = cellsUp(cells);
        int perCellUp = layers / cellsUp;
        float[] near = new float[81];
        float[] inReach = new float[near.length];
        for (int k = 0; k < cells; k++) {
            for (int j = 0; j < cellsUp; j++) {
                for (int i = 0; i < cells; i++) {
                    gather(points, cells, i, j, k, near);
                    int corner = (k * perCell * layers + j * perCellUp) * size + i * perCell;
                    addCellularCell(sum, corner, perCell, near, inReach, weight);
                }
            }
        }
    }

    /** Returns three coordinates for each cell, relative to its corner. */
    private float[] points(int cells) {
        int cellsUp = cellsUp(cells);
        float[] points = new float[3 * cells * cellsUp * cells];
        for (int k = 0, at = 0; k < cells; k++) {
            for (int j = 0; j < cellsUp; j++) {
                for (int i = 0; i < cells; i++) {
                    for (int axis = 0; axis < 3; axis++) {
                        points[at++] = (float) hash.unit(i + cells * axis, j, k + cells);
                    }
                }
            }
        }
        return points;
    }

    /** Collects the points of a cell and of the 26 around it, relative to its corner. */
    private void gather(float[] points, int cells, int i, int j, int k, float[] near) {
        int cellsUp = cellsUp(cells);
        int at = 0;
        for (int c = -1; c <= 1; c++) {
            for (int b = -1; b <= 1; b++) {
                for (int a = -1; a <= 1; a++) {
                    int x = Math.floorMod(i + a, cells);
                    int y = Math.floorMod(j + b, cellsUp);
                    int z = Math.floorMod(k + c, cells);
                    int point = 3 * ((z * cellsUp + y) * cells + x);
                    near[at++] = points[point] + a;
                    near[at++] = points[point + 1] + b;
                    near[at++] = points[point + 2] + c;
                }
            }
        }
    }

    /** @param inReach is overwritten */
    private void addCellularCell(float[] sum, int corner, int perCell, float[] near, float[] inReach, float weight) {
        int perCellUp = layers == 1 ? 1 : perCell;
        for (int k = 0; k < perCell; k++) {
            float z = (k + 0.5f) / perCell;
            for (int j = 0; j < perCellUp; j++) {
                float y = (j + 0.5f) / perCellUp;
                int count = putInReach(near, y, z, inReach);
                int at = corner + (k * layers + j) * size;
                for (int i = 0; i < perCell; i++) {
                    sum[at + i] += weight * nearest(inReach, count, (i + 0.5f) / perCell, y, z);
                }
            }
        }
    }

    /** Keeps the points that are less than a cell from a row: of 27 some nine. Returns how many numbers they are. */
    private static int putInReach(float[] near, float y, float z, float[] inReach) {
        int count = 0;
        for (int at = 0; at < near.length; at += 3) {
            float dy = near[at + 1] - y;
            float dz = near[at + 2] - z;
            if (dy * dy + dz * dz <= 1) {
                inReach[count++] = near[at];
                inReach[count++] = near[at + 1];
                inReach[count++] = near[at + 2];
            }
        }
        return count;
    }

    private static float nearest(float[] points, int count, float x, float y, float z) {
        float least = 1;
        for (int at = 0; at < count; at += 3) {
            float dx = points[at] - x;
            float dy = points[at + 1] - y;
            float dz = points[at + 2] - z;
            least = Math.min(least, dx * dx + dy * dy + dz * dz);
        }
        return (float) Math.sqrt(least);
    }
}
