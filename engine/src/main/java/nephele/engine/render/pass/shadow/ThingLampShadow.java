package nephele.engine.render.pass.shadow;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import nephele.engine.level.appearance.Lamp;
import nephele.engine.math.Frustum;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.SharedResources;
import nephele.engine.render.frame.SurfaceLight;
import nephele.engine.render.frame.Target;
import nephele.engine.render.frame.ThingMeshes;
import nephele.engine.render.frame.ThingShade;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.SharedObjects.Same;
import nephele.engine.render.gl.Texture;
import nephele.engine.scene.light.LampShadows;
import nephele.engine.scene.thing.VisibleThings;
import org.joml.Matrix4d;

/** The lamps' depth pictures of what moves: the same layers and projections as those of what never moves. */
final class ThingLampShadow {
    /** @param clipFromAnchor the layer's projection */
    private record Layer(Matrix4d clipFromAnchor, Frustum frustum, Lamp lamp) {}

    /** What the pictures show: the things of one renderer as they once stood. */
    private record Content(Same things, long state) {}

    private final SharedResources shared;
    private final Same things;
    private final ThingDepthDraw depth;
    private final ThingShade shade;
    private final List<Layer> layers = new ArrayList<>();
    private final VisibleThings visible;
    private final DepthLayers maps;
    private final Texture.Extent extent;
    private List<Content> contents = List.of();

    ThingLampShadow(LoadContext context, ThingMeshes meshes, ThingDepthDraw depth) {
        shared = context.shared();
        things = new Same(meshes);
        this.depth = depth;
        SurfaceLight surfaceLight = shared.surfaceLight();
        shade = surfaceLight.thingShade();
        List<Lamp> lamps = surfaceLight.lamps().lamps();
        LampShadows shadows = surfaceLight.lamps().shadows();
        for (int i = 0; i < shadows.layers().size(); i++) {
            Lamp lamp = lamps.get(shadows.layers().get(i).lamp());
            Matrix4d clip = shadows.clipFromAnchor(lamps, i, surfaceLight.anchor());
            layers.add(new Layer(clip, Frustum.of(clip, surfaceLight.anchor()), lamp));
        }
        extent = new Texture.Extent(shadows.side(), shadows.side(), layers.size());
        maps = DepthDraw.layers(context, "lamp shadows of things");
        visible = new VisibleThings(meshes.things(), meshes.copies());
    }

    /**
     * Draws the pictures again where they show something else.
     *
     * @param state of the things: another number where any has moved
     */
    void follow(long state) {
        if (contents.isEmpty() || contents.get(0).state != state) {
            contents = Collections.nCopies(extent.layers(), new Content(things, state));
        }
        shared.publish(Target.THING_LAMP_SHADOW, maps.showing(contents, extent, this::draw));
    }

    private void draw(int number, RenderTarget target) {
        Layer layer = layers.get(number);
        visible.find(layer.frustum, layer.lamp.position(), extent.width() / 2.0);
        boolean isUsed = visible.runs() > 0;
        shade.layer(number, isUsed);
        if (isUsed) {
            target.clearDepth();
            depth.draw(visible, layer.clipFromAnchor, LampShadows.depthPerMetre(layer.lamp));
        }
    }
}
