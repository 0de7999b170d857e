package nephele.engine.cloud.field;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.level.Cloud;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/** One field of each kind around the origin, and rays that meet them. */
public final class SampleFields {
    public static final Aabb BOX = new Aabb(-30, -20, -40, 30, 20, 40);

    private SampleFields() {}

    public static Map<String, ExtinctionField> all() {
        double infinite = Double.POSITIVE_INFINITY;
        var layer = new Aabb(-infinite, -20, -infinite, infinite, 20, infinite);
        var fields = new LinkedHashMap<String, ExtinctionField>();
        fields.put("uniform", new UniformField(BOX, 0.03));
        fields.put("uniform layer", new UniformField(layer, 0.03));
        fields.put("ellipsoid", new EllipsoidField(BOX, 0.05));
        fields.put("puffs", new PuffsField(puffs(40), new Vec3(3, 4, 5), 0.05));
        fields.put("grid", GridField.inBox(randomGrid(13, 6, 9), BOX, 0.1));
        fields.put("fine grid", GridField.inBox(randomGrid(2, 64, 1), BOX, 0.1));
        fields.put("repeated grid", GridField.repeated(randomGrid(13, 6, 9), BOX, 0.1));
        fields.put("noise", new NoiseField(BOX, 7, 11, 0.5, 0.2));
        fields.put("fine noise", new NoiseField(BOX, 7, 0.01, 0.9, 0.2));
        fields.put("noise layer", new NoiseField(layer, 8, 11, 0.4, 0.2));
        return fields;
    }

    static List<Cloud.Puff> puffs(int count) {
        var random = new SplittableRandom(1);
        var puffs = new ArrayList<Cloud.Puff>();
        for (int i = 0; i < count; i++) {
            puffs.add(new Cloud.Puff(point(random, 20), random.nextDouble(1, 15)));
        }
        return puffs;
    }

    static VoxelGrid randomGrid(int nx, int ny, int nz) {
        var random = new SplittableRandom(2);
        float[] values = new float[nx * ny * nz];
        for (int i = 0; i < values.length; i++) {
            values[i] = (float) Math.max(0, random.nextDouble(-1, 1));
        }
        return new VoxelGrid(nx, ny, nz, BOX, values);
    }

    static Vec3 point(SplittableRandom random, double reach) {
        return new Vec3(
                random.nextDouble(-reach, reach), random.nextDouble(-reach, reach), random.nextDouble(-reach, reach));
    }

    /** Returns a ray of unit direction from 100 m away or from inside; every fourth is parallel to an axis. */
    public static Ray ray(SplittableRandom random) {
        Vec3 from = point(random, random.nextBoolean() ? 100 : 20);
        Vec3 to = point(random, 15);
        Vec3 axis = new Vec3(0, random.nextBoolean() ? 1 : -1, 0);
        Vec3 d = random.nextInt(4) == 0
                ? axis
                : to.minus(from).scaled(1 / to.minus(from).length());
        return Ray.of(from, d);
    }
}
