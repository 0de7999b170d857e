package nephele.lab.generate;

import nephele.engine.math.Pcg3d;

/**
 * Erosion by drops of water that run downhill, take material where they gain speed and leave it where they lose it (Beyer
 * 2015, "Implementation of a method for hydraulic erosion", simplified). Drops run one after the other, in the order of
 * their numbers.
 */
final class Erosion {
    private static final int MOST_DROPS = 400_000;
    private static final int STEPS = 48;
    private static final double INERTIA = 0.12;
    private static final double CAPACITY = 2.5;
    private static final double LEAST_SLOPE = 0.01;
    private static final double TAKEN = 0.08;
    private static final double LEFT = 0.25;
    private static final double EVAPORATION = 0.98;
    private static final double GRAVITY = 4;

    /** The height range, in cells, for which the constants are chosen. */
    private static final double RELIEF = 0.22;

    private final float[] heights;
    private final int side;

    private Erosion(float[] heights, int side) {
        this.heights = heights;
        this.side = side;
    }

    /** Changes heights of 0 to 1 of a square. */
    static void erode(float[] heights, int side, int seed) {
        if (side < 8) {
            return;
        }
        Erosion erosion = new Erosion(heights, side);
        int drops = (int) Math.min(MOST_DROPS, (long) side * side / 4);
        for (int drop = 0; drop < drops; drop++) {
            Pcg3d bits = Pcg3d.of(drop, seed, 77);
            erosion.run(1 + (side - 4) * Pcg3d.unit(bits.x()), 1 + (side - 4) * Pcg3d.unit(bits.y()));
        }
    }

    private void run(double x, double z) {
        double scale = RELIEF * side;
        double directionX = 0;
        double directionZ = 0;
        double speed = 1;
        double water = 1;
        double load = 0;
        for (int step = 0; step < STEPS; step++) {
            int column = (int) x;
            int row = (int) z;
            double u = x - column;
            double v = z - row;
            double riseX = scale * mix(rise(column, row, 1, 0), rise(column, row + 1, 1, 0), v);
            double riseZ = scale * mix(rise(column, row, 0, 1), rise(column + 1, row, 0, 1), u);
            directionX = directionX * INERTIA - riseX * (1 - INERTIA);
            directionZ = directionZ * INERTIA - riseZ * (1 - INERTIA);
            double length = Math.sqrt(directionX * directionX + directionZ * directionZ);
            if (length < 1e-9) {
                return;
            }
            directionX /= length;
            directionZ /= length;
            double before = height(x, z);
            x += directionX;
            z += directionZ;
            if (!(x >= 1 && z >= 1 && x < side - 3 && z < side - 3)) {
                return;
            }
            double fall = scale * (before - height(x, z));
            double most = Math.max(fall, LEAST_SLOPE) * speed * water * CAPACITY;
            double change;
            if (fall < 0) {
                change = Math.min(-fall, load);
            } else if (load > most) {
                change = (load - most) * LEFT;
            } else {
                change = -Math.min((most - load) * TAKEN, fall);
            }
            load -= change;
            change(column, row, u, v, change / scale);
            speed = Math.sqrt(Math.max(0, speed * speed + fall * GRAVITY));
            water *= EVAPORATION;
        }
    }

    private double rise(int column, int row, int across, int along) {
        return heights[(row + along) * side + column + across] - heights[row * side + column];
    }

    private double height(double x, double z) {
        int column = (int) x;
        int row = (int) z;
        int at = row * side + column;
        double u = x - column;
        return mix(mix(heights[at], heights[at + 1], u), mix(heights[at + side], heights[at + side + 1], u), z - row);
    }

    /** Adds material around a place: half to the four samples of its cell, the rest to those around, so no pits arise. */
    private void change(int column, int row, double u, double v, double amount) {
        int at = row * side + column;
        for (int corner = 0; corner < 4; corner++) {
            int across = corner & 1;
            int along = corner >> 1;
            double weight = (across == 0 ? 1 - u : u) * (along == 0 ? 1 - v : v);
            int sample = at + across + along * side;
            heights[sample] += (float) (0.5 * amount * weight);
            heights[sample - 1] += (float) (0.125 * amount * weight);
            heights[sample + 1] += (float) (0.125 * amount * weight);
            heights[sample - side] += (float) (0.125 * amount * weight);
            heights[sample + side] += (float) (0.125 * amount * weight);
        }
    }

    private static double mix(double a, double b, double t) {
        return a + (b - a) * t;
    }
}
