package nephele.engine.render.pass.shadow;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.math.Frustum;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.SharedObjects.Identity;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.resource.DynamicMeshes;
import nephele.engine.render.resource.DynamicShadows;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.scene.dynamic.VisibleInstances;
import nephele.engine.scene.light.LightShadowLayers;
import org.joml.Matrix4d;

/**
 * The punctual lights' depth pictures of dynamic objects, with the layers and projections of those of static geometry.
 */
final class DynamicLightShadow {
    /** @param clipFromAnchor the layer's projection */
    private record Layer(Matrix4d clipFromAnchor, Frustum frustum, PunctualLight light) {}

    private final Map<Target, Texture> targets;
    private final Identity dynamicObjects;
    private final DynamicDepthDraw depth;
    private final DynamicShadows shade;
    private final List<Layer> layers = new ArrayList<>();
    private final VisibleInstances visible;
    private final DepthLayers maps;
    private final Texture.Extent extent;
    private long state = -1;
    /** What each layer shows: the dynamic objects of one renderer in one state. */
    private List<?> contents = List.of();

    DynamicLightShadow(LoadContext context, DynamicMeshes meshes, DynamicDepthDraw depth) {
        targets = context.targets();
        dynamicObjects = new Identity(meshes);
        this.depth = depth;
        SurfaceLight surfaceLight = context.get(SurfaceLight.RESOURCE);
        shade = surfaceLight.dynamicShadows();
        List<PunctualLight> lights = surfaceLight.lights().lights();
        LightShadowLayers shadows = surfaceLight.lights().shadows();
        for (int i = 0; i < shadows.layers().size(); i++) {
            PunctualLight light = lights.get(shadows.layers().get(i).light());
            Matrix4d clip = shadows.clipFromAnchor(lights, i, surfaceLight.anchor());
            layers.add(new Layer(clip, Frustum.of(clip, surfaceLight.anchor()), light));
        }
        extent = new Texture.Extent(shadows.side(), shadows.side(), layers.size());
        maps = DepthDraw.layers(context, "light shadows of dynamic objects");
        visible = new VisibleInstances(meshes.dynamicObjects(), meshes.copies());
    }

    /**
     * Redraws the pictures if their content differs.
     *
     * @param now the state of the dynamic objects: another number if any has moved
     */
    void follow(long now) {
        if (contents.isEmpty() || state != now) {
            state = now;
            contents = Collections.nCopies(extent.layers(), List.of(dynamicObjects, now));
        }
        targets.put(Target.DYNAMIC_LIGHT_SHADOW, maps.showing(contents, extent, this::draw));
    }

    private void draw(int number, RenderTarget target, Object before) {
        Layer layer = layers.get(number);
        visible.find(layer.frustum, layer.light.position(), extent.width() / 2.0);
        boolean isUsed = visible.runs() > 0;
        shade.layer(number, isUsed);
        if (isUsed) {
            target.clearDepth();
            depth.draw(visible, layer.clipFromAnchor, LightShadowLayers.depthPerMetre(layer.light));
        }
    }
}
