package nephele.workshop.prove.edits;

import java.util.Arrays;
import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.engine.scene.light.bake.IndirectLight;
import nephele.engine.scene.light.bake.LightCache;
import nephele.engine.scene.light.bake.LightSamples;
import nephele.engine.scene.light.bake.SkyVisibility;
import nephele.engine.sim.state.SimLevel;

/** Everything that is derived from a level without OpenGL, as the editor keeps it. */
public record EditedTown(PlacedLevel placed, Scene scene, SimLevel simulated) {
    /** Bakes the sky's light; nothing is saved to disk. */
    public static BakedLight baked(PlacedLevel placed) {
        SkyVisibility visibility = new LightCache(placed.assets(), List.of())
                .of(placed.statics().split(SkyVisibility.MODEL_EDGE_METRES), done -> {});
        return new BakedLight(visibility, null);
    }

    /**
     * Bakes the sky's light, and lets as much bounce everywhere. What an edit costs does not depend on how bright baked
     * light is, and the true one takes many minutes.
     */
    public static BakedLight bouncing(PlacedLevel placed) {
        SkyVisibility sky = baked(placed).visibility();
        List<IndirectLight.Layer> layers = Arrays.stream(IndirectLight.Course.values())
                .map(course -> new IndirectLight.Layer(
                        "", course, asBrightAs(sky.texels()), asBrightAs(sky.ofModels()), List.of()))
                .toList();
        return new BakedLight(sky, new IndirectLight(IndirectLight.SkyLight.BAKED, layers));
    }

    private static LightSamples asBrightAs(short[] visibility) {
        LightSamples light = LightSamples.black(visibility.length);
        for (int i = 0; i < visibility.length; i++) {
            float value = (visibility[i] & 0xffff) / 65535f;
            Arrays.fill(light.radiance(), LightSamples.CHANNELS * i, LightSamples.CHANNELS * (i + 1), value);
            light.moments()[LightSamples.MOMENTS * i + 1] = value / 4;
            light.moments()[LightSamples.MOMENTS * i + 3] = value / 2;
        }
        return light;
    }

    /**
     * Derives everything anew, as loading a level does.
     *
     * @param baked for this level or an earlier one; used if the sky lights the level
     */
    static EditedTown of(PlacedLevel placed, BakedLight baked) {
        BakedLight light = LightRequirements.skyVisibility(placed.level()) ? baked : null;
        return new EditedTown(placed, Scene.of(placed, light), SimLevel.of(placed));
    }

    /** Derives everything for an edited level and reuses the parts that do not differ. */
    EditedTown edited(Level level, BakedLight baked) {
        PlacedLevel other = placed.edited(level);
        return new EditedTown(other, scene.edited(other, baked), simulated.edited(placed, other));
    }
}
