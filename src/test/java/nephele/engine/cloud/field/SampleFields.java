package nephele.engine.cloud.field;

import static nephele.engine.level.CloudProfile.CUMULONIMBUS;
import static nephele.engine.level.CloudProfile.CUMULUS;
import static nephele.engine.level.CloudProfile.STRATUS;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import nephele.engine.asset.VoxelGrid;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.level.Cloud;
import nephele.engine.level.Cloud.Density.Noise;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/** One field of each kind around the origin, and rays that meet them. */
public final class SampleFields {
    public static final Aabb BOX = new Aabb(-30, -20, -40, 30, 20, 40);

    private static final Cloud.Extent BOX_EXTENT = new Cloud.Extent.Volume(Vec3.ZERO, new Vec3(60, 40, 80));
    private static final Cloud.Extent LAYER_EXTENT = new Cloud.Extent.Layer(-20, 40);
    private static final String MAP = "map.png";

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
        fields.put("noise", noise(BOX_EXTENT, new Noise(7, 11, 0.5)));
        fields.put("fine noise", noise(BOX_EXTENT, new Noise(7, 0.01, 0.9)));
        fields.put("noise layer", noise(LAYER_EXTENT, new Noise(8, 11, 0.4)));
        fields.put("anvil", noise(BOX_EXTENT, new Noise(3, 11, 1, 0.6, CUMULONIMBUS, null, 1)));
        return fields;
    }

    /** Returns more fields of noise, which are all made by the same classes. */
    static Map<String, ExtinctionField> noises() {
        var fields = new LinkedHashMap<String, ExtinctionField>();
        fields.put("mapped noise", noise(BOX_EXTENT, new Noise(8, 11, 1, 0.5, null, MAP, 0)));
        fields.put("mapped layer", noise(LAYER_EXTENT, new Noise(8, 400, 0.8, 0.5, STRATUS, MAP, 0)));
        fields.put("cumulus", noise(BOX_EXTENT, new Noise(9, 11, 0.8, 0.6, CUMULUS, null, 0)));
        fields.put("cumulus layer", noise(LAYER_EXTENT, new Noise(9, 6, 0.4, 0.3, CUMULUS, null, 0)));
        fields.put("mapped cumulus", noise(BOX_EXTENT, new Noise(9, 20, 1, 0, CUMULUS, MAP, 0)));
        fields.put("anvils", noise(LAYER_EXTENT, new Noise(3, 11, 0.3, 0.2, CUMULONIMBUS, null, 0.5)));
        return fields;
    }

    private static ExtinctionField noise(Cloud.Extent extent, Noise density) {
        return TestClouds.field(extent, density, 0.2, new Cloud.Motion(Vec3.ZERO, 10), 3);
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
