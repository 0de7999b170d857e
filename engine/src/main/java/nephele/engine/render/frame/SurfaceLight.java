package nephele.engine.render.frame;

import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.SharedObjects.Same;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.resource.LightBlock;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.PunctualLightTable;
import nephele.engine.scene.light.ShadowFrame;
import nephele.engine.scene.light.SkyIrradiance;

/**
 * The light of a level for every shader that includes {@code surface-light.glsl}: its defines, numbers and textures.
 * Positions are relative to the {@link #anchor}, so none of it moves with the eye.
 */
public final class SurfaceLight implements GlObject {
    private final Level level;
    private final Scene scene;
    private final SharedResources shared;
    private final LightMaps maps;
    private final LightBlock block;
    private final SunLight sun;
    private final PunctualLighting lights;
    private final DynamicShadows dynamicObjectShade;
    private Environment followed;

    SurfaceLight(GlContext gl, Scene scene, FrameRequest request, SharedResources shared) {
        this.scene = scene;
        this.shared = shared;
        level = scene.level();
        maps = request.lightMaps();
        block = shared.own(new LightBlock(gl));
        sun = new SunLight(request, scene.statics(), anchor());
        lights = new PunctualLighting(gl, request, scene.lights(), anchor());
        dynamicObjectShade = new DynamicShadows(gl, maps);
    }

    /**
     * Brings the numbers to what the light outside is now. Nothing is derived for an environment that is already shown.
     *
     * @param now of the level's kind: where sun, sky or constant are none in the level, there are none
     */
    void follow(Environment now) {
        if (now == followed) {
            return;
        }
        sun.put(now.sun(), block);
        lights.put(block);
        if (now.ambient() != null) {
            block.ambient(now.ambient());
        }
        if (LightRequirements.skyShines(level)
                && (followed == null || !now.sky().equals(followed.sky()))) {
            block.sky(irradiance(now.sky()));
        }
        block.upload();
        followed = now;
    }

    private record SkyOfLevel(Same level, Sky sky) {}

    private SkyIrradiance irradiance(Sky sky) {
        return shared.shareValue(SkyIrradiance.class, new SkyOfLevel(shared.openedLevel(), sky), () -> SkyRadiance.of(
                        sky, shared::picture, ColourDecoding.SRGB)
                .map(SkyIrradiance::of)
                .orElseGet(SkyIrradiance::black));
    }

    /** World position that positions in light shaders are relative to. */
    public Vec3 anchor() {
        return scene.solids().isEmpty() ? Vec3.ZERO : scene.solids().origin();
    }

    /** What the shadows of things need. */
    public DynamicShadows dynamicObjectShade() {
        return dynamicObjectShade;
    }

    /** The sun's map as the sun stands now; {@code null} without a sun that casts. */
    public ShadowFrame sunFrame() {
        return sun.frame();
    }

    /** {@code null} without lamps. */
    public PunctualLightTable lights() {
        return lights.table();
    }

    private boolean hasSkyVisibility() {
        return maps.has(Target.SKY_VISIBILITY);
    }

    /** Whether light differs from point to point of a face. */
    public boolean variesOverFaces() {
        return needsPositions() || hasSkyVisibility();
    }

    /** Whether shaders need to know where on the level they are. */
    public boolean needsPositions() {
        return sun.hasShadow() || lights.table() != null || dynamicObjectShade.sun();
    }

    public Defines addTo(Defines defines) {
        return addForModels(defines).withIf(hasSkyVisibility(), "SKY_VISIBILITY");
    }

    /** The same for models, whose share of the sky stands in their vertices. */
    public Defines addForModels(Defines defines) {
        return addLights(defines).withIf(needsPositions(), "ANCHOR_POSITION").withIf(hasSkyVisibility(), "SKY_AMBIENT");
    }

    /** The same for what moves: it has no place in the light map, so its share of the sky comes otherwise. */
    public Defines addForDynamicObjects(Defines defines) {
        return addLights(defines).with("ANCHOR_POSITION").withIf(LightRequirements.skyShines(level), "SKY_AMBIENT");
    }

    private Defines addLights(Defines defines) {
        return lights.addTo(sun.addTo(dynamicObjectShade.addTo(defines)))
                .withIf(level.environment().ambient() != null, "AMBIENT_CONSTANT");
    }

    /** Ties what a program compiled with {@link #addTo} reads to where it is bound. */
    public void tie(Uniforms uniforms) {
        tieForModels(uniforms);
        if (hasSkyVisibility()) {
            uniforms.sampler("skyVisibilityMap", TextureUnit.SKY_VISIBILITY);
        }
    }

    /** The same for {@link #addForModels}. */
    public void tieForModels(Uniforms uniforms) {
        tieLights(uniforms, hasSkyVisibility());
    }

    /** The same for {@link #addForDynamicObjects}. */
    public void tieForDynamicObjects(Uniforms uniforms) {
        tieLights(uniforms, LightRequirements.skyShines(level));
    }

    private void tieLights(Uniforms uniforms, boolean ofSky) {
        dynamicObjectShade.tie(uniforms);
        sun.tie(uniforms);
        lights.tie(uniforms);
        if (sun.shines() || lights.table() != null || level.environment().ambient() != null || ofSky) {
            uniforms.block("Light", LightBlock.BINDING);
        }
    }

    /**
     * Binds what a program needs that was made with {@link #addTo}, {@link #addForModels} or {@link #addForDynamicObjects}.
     *
     * @param reads of {@link LightMaps}, as the pass declares them
     */
    public void bind(TargetReads reads) {
        reads.bind(shared);
        block.bind();
        lights.bind();
        dynamicObjectShade.bind();
    }

    @Override
    public void close() {
        dynamicObjectShade.close();
        lights.close();
    }
}
