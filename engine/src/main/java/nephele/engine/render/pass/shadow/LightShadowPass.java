package nephele.engine.render.pass.shadow;

import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.FrameContext;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Pass;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.frame.Stage;
import nephele.engine.render.frame.Target;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.SharedObjects.Identity;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.resource.SolidMesh;
import nephele.engine.render.resource.SurfaceLight;
import nephele.engine.render.resource.TerrainMesh;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.LightShadowLayers;
import nephele.engine.scene.light.PunctualLightTable;

/**
 * Draws the punctual lights' depth pictures, layers of one texture, again when their light, or a solid near it, has
 * changed.
 */
public final class LightShadowPass implements Pass {
    public static final RenderFeature FEATURE = new RenderFeature(
                    "shadow.lights", Stage.ONCE_A_FRAME, LightShadowPass::requiredBy)
            .using(SolidMesh.RESOURCE, TerrainMesh.RESOURCE, SurfaceLight.RESOURCE);

    private final Map<Target, Texture> targets;
    private final List<PunctualLight> lights;
    private final LightShadowLayers shadows;
    private final Vec3 anchor;
    private final DepthDraw depth;
    private final DepthLayers maps;
    /** The data on which the picture in each layer depends. */
    private final List<?> contents;

    private final Texture.Extent extent;

    private LightShadowPass(LoadContext context) {
        targets = context.targets();
        SurfaceLight light = context.get(SurfaceLight.RESOURCE);
        PunctualLightTable table = light.lights();
        lights = table.lights();
        shadows = table.shadows();
        anchor = light.anchor();
        depth = new DepthDraw(context);
        maps = DepthDraw.layers(context, "light shadows");
        contents = shadows.layers().stream()
                .map(layer -> List.of(
                        lights.get(layer.light()),
                        layer.axis(),
                        new Identity(table.shadowToken(layer.light())),
                        anchor))
                .toList();
        extent = new Texture.Extent(
                shadows.side(), shadows.side(), shadows.layers().size());
    }

    private static List<Required> requiredBy(FrameRequest request) {
        return request.lightMaps().has(Target.LIGHT_SHADOW)
                ? List.of(new Required(because(request.level()), LightShadowPass::new))
                : List.of();
    }

    private static String because(Level level) {
        for (int i = 0; i < level.lights().size(); i++) {
            if (LightRequirements.casts(level.lights().get(i))) {
                return "lights[" + i + "].castsShadow: " + LightRequirements.surfaces(level) + " that shade others";
            }
        }
        throw new IllegalArgumentException("no punctual light casts");
    }

    @Override
    public Set<Target> writes() {
        return Set.of(Target.LIGHT_SHADOW);
    }

    @Override
    public void draw(FrameContext frame) {
        targets.put(Target.LIGHT_SHADOW, maps.showing(contents, extent, this::draw));
    }

    private void draw(int layer, RenderTarget target, Object before) {
        PunctualLight light = lights.get(shadows.layers().get(layer).light());
        depth.drawInFrustum(
                target, shadows.clipFromAnchor(lights, layer, anchor), anchor, LightShadowLayers.depthPerMetre(light));
    }
}
