package nephele.workshop.art.bench;

import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.Terrain;
import nephele.engine.math.Vec3;

/** The terrain of the compared engines: seven octaves of noise, each of half the height and half the width. */
public final class BenchTerrain {
    /** The map of the level; its heights are rounded to 2 mm. */
    public static final String MAP = "terrain/bench.png";

    /** The ground's picture. */
    public static final String PICTURE = "textures/bench/ground.png";

    /** Samples along a side. */
    public static final int SIDE = 1025;

    private static final int OCTAVES = 7;
    private static final int FIRST_SEED = 50;
    /** The sum of all octaves stays below. */
    private static final double MOST_METRES = 127;

    private BenchTerrain() {}

    /** Returns a height in metres, at least 0 and less than 127; samples are 1 m apart. */
    public static double metres(int column, int row) {
        float sum = 0;
        float height = 64;
        float perMetre = 1 / 256f;
        for (int octave = 0; octave < OCTAVES; octave++) {
            sum += BenchPixels.noise(column * perMetre, row * perMetre, FIRST_SEED + octave) * height;
            height *= 0.5f;
            perMetre *= 2;
        }
        return sum;
    }

    /** Returns the map's values from 0 to 1, row by row. */
    public static float[] map() {
        float[] values = new float[SIDE * SIDE];
        for (int i = 0; i < values.length; i++) {
            values[i] = (float) (metres(i % SIDE, i / SIDE) / MOST_METRES);
        }
        return values;
    }

    /** Returns an empty level with the ground. */
    static Level on(Level empty) {
        Material ground = new Material("ground", new Vec3(1, 1, 1), PICTURE, null, null, null, Vec3.ZERO, SIDE - 1);
        Terrain terrain = new Terrain(
                "ground",
                MAP,
                Vec3.ZERO,
                new Terrain.Sides(SIDE - 1, SIDE - 1),
                new Terrain.HeightRange(0, MOST_METRES),
                List.of(Terrain.Layer.everywhere("ground")),
                false);
        return empty.with(List.of(ground), List.of()).withTerrains(List.of(terrain));
    }
}
