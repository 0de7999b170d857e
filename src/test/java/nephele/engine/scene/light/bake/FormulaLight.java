package nephele.engine.scene.light.bake;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.scene.light.TerrainSky;
import nephele.engine.scene.light.bake.IndirectLight.Course;
import nephele.engine.scene.light.bake.IndirectLight.Layer;
import nephele.engine.scene.light.bake.IndirectLight.SkyLight;
import org.joml.Vector3d;

/** Baked light that is a formula of the place, for tests of drawing. */
public final class FormulaLight {
    private final SkyVisibility visibility;
    private final List<Layer> layers = new ArrayList<>();

    /** Lays out the light of some shapes, under an open sky. */
    public FormulaLight(StaticShapes statics) {
        StaticShapes split = statics.split(SkyVisibility.MODEL_EDGE_METRES);
        LightMapLayout layout = LightMapLayout.of(split.solids());
        visibility = new SkyVisibility(
                layout,
                split,
                open(layout.width() * layout.height()),
                open(split.models().vertexCount()));
    }

    private static short[] open(int points) {
        short[] all = new short[points];
        Arrays.fill(all, (short) 0xffff);
        return all;
    }

    /**
     * Adds a layer.
     *
     * @param radiance by the place
     * @param direction the mean direction of the light everywhere
     */
    public FormulaLight layer(String name, Course course, Function<Vec3, Vec3> radiance, Vec3 direction) {
        layers.add(new Layer(
                name,
                course,
                samples(texels(), radiance, direction),
                samples(vertices(), radiance, direction),
                visibility.statics().ground().stream()
                        .map(grid -> samples(points(grid), radiance, direction))
                        .toList()));
        return this;
    }

    public BakedLight baked(SkyLight sky) {
        return new BakedLight(visibility, new IndirectLight(sky, List.copyOf(layers)));
    }

    private Vec3[] texels() {
        LightMapLayout layout = visibility.layout();
        Vec3[] places = new Vec3[layout.width() * layout.height()];
        for (int i = 0; i < layout.charts().size(); i++) {
            LightMapChart chart = layout.charts().get(i);
            Vec3 corner = chart.outline().get(0);
            double distance = chart.normal().dot(corner.x(), corner.y(), corner.z());
            for (int row = 0; row < chart.rows(); row++) {
                for (int column = 0; column < chart.columns(); column++) {
                    double s = chart.minAcross() + chart.widthMetres() * column / (chart.columns() - 1);
                    double t = chart.minUp() + chart.heightMetres() * row / (chart.rows() - 1);
                    places[(layout.rowOf()[i] + row) * layout.width() + layout.columnOf()[i] + column] =
                            Vec3.of(new Vector3d(chart.normal())
                                    .mul(distance)
                                    .fma(s, chart.across())
                                    .fma(t, chart.up()));
                }
            }
        }
        return places;
    }

    private Vec3[] vertices() {
        List<Vec3> places = new ArrayList<>();
        for (PlacedModel model : visibility.statics().models().all()) {
            double[] xyz = model.triangles().positions();
            for (int i = 0; i < xyz.length; i += 3) {
                places.add(new Vec3(xyz[i], xyz[i + 1], xyz[i + 2]));
            }
        }
        return places.toArray(Vec3[]::new);
    }

    private static Vec3[] points(StaticShape.HeightGrid grid) {
        HeightField field = grid.field();
        int columns = TerrainSky.points(field.cellColumns());
        Vec3[] places = new Vec3[columns * TerrainSky.points(field.cellRows())];
        for (int i = 0; i < places.length; i++) {
            double x = field.x(0) + field.cellX() * field.cellColumns() * (i % columns) / (columns - 1);
            double z = field.z(0) + field.cellZ() * field.cellRows() * (i / columns) / (places.length / columns - 1);
            places[i] = new Vec3(x, 0, z);
        }
        return places;
    }

    private static LightSamples samples(Vec3[] places, Function<Vec3, Vec3> radiance, Vec3 direction) {
        LightSamples samples = LightSamples.black(places.length);
        for (int i = 0; i < places.length; i++) {
            if (places[i] != null) {
                Vec3 rgb = radiance.apply(places[i]);
                Vec3 moment = direction.scaled(rgb.y());
                put(samples.radiance(), 3 * i, rgb.x(), rgb.y(), rgb.z());
                put(samples.moments(), 4 * i, moment.x(), moment.y(), moment.z(), rgb.y());
            }
        }
        return samples;
    }

    private static void put(float[] to, int at, double... values) {
        for (int i = 0; i < values.length; i++) {
            to[at + i] = (float) values[i];
        }
    }
}
