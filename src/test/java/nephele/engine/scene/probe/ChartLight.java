package nephele.engine.scene.probe;

import java.util.List;
import java.util.function.Function;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.TestLevel;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.engine.scene.light.bake.IndirectLight;
import nephele.engine.scene.light.bake.LightMapChart;
import nephele.engine.scene.light.bake.LightMapLayout;
import nephele.engine.scene.light.bake.LightSamples;
import nephele.engine.scene.light.bake.PolygonClipping;
import nephele.engine.scene.light.bake.SkyVisibility;

/** Scenes of boxes under no sky, each chart of which has one light that a formula gives. */
public final class ChartLight {
    private ChartLight() {}

    /**
     * Returns the scene of a level, under no sky.
     *
     * @param light irradiance / π on a chart with this centre, RGB
     */
    public static Scene scene(TestLevel level, Function<Vec3, Vec3> light) {
        PlacedLevel placed = PlacedLevel.of(level.level(), TestAssets.NONE);
        LightMapLayout layout = LightMapLayout.of(placed.statics().solids());
        int texels = layout.width() * layout.height();
        LightSamples samples = LightSamples.black(texels);
        for (int i = 0; i < layout.charts().size(); i++) {
            LightMapChart chart = layout.charts().get(i);
            Vec3 rgb = light.apply(PolygonClipping.centroid(chart.outline()));
            for (int texel = 0; texel < chart.columns() * chart.rows(); texel++) {
                int row = layout.rowOf()[i] + texel / chart.columns();
                int at = 3 * (row * layout.width() + layout.columnOf()[i] + texel % chart.columns());
                samples.radiance()[at] = (float) rgb.x();
                samples.radiance()[at + 1] = (float) rgb.y();
                samples.radiance()[at + 2] = (float) rgb.z();
            }
        }
        LightSamples none = LightSamples.black(0);
        var layer = new IndirectLight.Layer("", IndirectLight.Course.INDIRECT, samples, none, List.of());
        SkyVisibility closed = new SkyVisibility(layout, placed.statics(), new short[texels], new short[0]);
        var indirect = new IndirectLight(IndirectLight.SkyLight.BAKED, List.of(layer));
        return Scene.of(placed, new BakedLight(closed, indirect));
    }
}
