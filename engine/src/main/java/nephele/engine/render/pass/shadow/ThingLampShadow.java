package nephele.engine.render.pass.shadow;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.appearance.Lamp;
import nephele.engine.math.Frustum;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.SurfaceLight;
import nephele.engine.render.frame.Target;
import nephele.engine.render.frame.ThingMeshes;
import nephele.engine.render.frame.ThingShade;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.scene.light.LampShadows;
import nephele.engine.scene.thing.VisibleThings;
import org.joml.Matrix4d;

/** The lamps' depth pictures of what moves: the same layers and projections as those of what never moves. */
final class ThingLampShadow {
    /** @param clipFromAnchor the layer's projection */
    private record Layer(RenderTarget target, Matrix4d clipFromAnchor, Frustum frustum, Lamp lamp) {}

    private final ThingShade shade;
    private final List<Layer> layers = new ArrayList<>();
    private final boolean[] used;
    private final VisibleThings visible;
    private final int side;

    ThingLampShadow(LoadContext context, ThingMeshes meshes) {
        SurfaceLight light = context.shared().surfaceLight();
        shade = light.thingShade();
        List<Lamp> lamps = light.lamps().lamps();
        LampShadows shadows = light.lamps().shadows();
        side = shadows.side();
        Texture.Extent extent =
                new Texture.Extent(side, side, Math.max(1, shadows.layers().size()));
        Texture maps = context.own(new Texture(
                context.gl(),
                "lamp shadows of things",
                Texture.Shape.ARRAY,
                PixelFormat.DEPTH32F,
                extent,
                Sampling.NEAREST_CLAMP));
        for (int i = 0; i < shadows.layers().size(); i++) {
            Lamp lamp = lamps.get(shadows.layers().get(i).lamp());
            Matrix4d clip = shadows.clipFromAnchor(lamps, i, light.anchor());
            layers.add(new Layer(
                    context.own(RenderTarget.depthLayer(context.gl(), "lamp shadow of things " + i, maps, i)),
                    clip,
                    Frustum.of(clip, light.anchor()),
                    lamp));
        }
        used = new boolean[layers.size()];
        visible = new VisibleThings(meshes.things(), meshes.copies());
        context.shared().publish(Target.THING_LAMP_SHADOW, maps);
    }

    void draw(ThingDepthDraw depth) {
        for (int i = 0; i < used.length; i++) {
            Layer layer = layers.get(i);
            visible.find(layer.frustum, layer.lamp.position(), side / 2.0);
            used[i] = visible.runs() > 0;
            shade.layer(i, used[i]);
            if (used[i]) {
                layer.target.clearDepth();
                depth.draw(visible, layer.clipFromAnchor, LampShadows.depthPerMetre(layer.lamp));
            }
        }
    }
}
