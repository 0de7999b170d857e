package nephele.engine.render.resource;

import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.billboard.PlantedBillboards;
import nephele.engine.level.billboard.PlantedModels;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.LightMaps;
import nephele.engine.render.frame.LightMaps.Baked;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.Quality.LightParts;
import nephele.engine.render.frame.Quality.ShadowSampling;
import nephele.engine.render.frame.SharedResource;
import nephele.engine.render.frame.Target;
import nephele.engine.render.frame.TargetReads;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.UniformBuffer;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.UniformBlock;
import nephele.engine.scene.FrameState;
import nephele.engine.scene.Scene;
import nephele.engine.scene.dynamic.ContactCasters;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.PunctualLightTable;
import nephele.engine.scene.light.ShadowCasters;
import nephele.engine.scene.light.ShadowFrame;
import org.lwjgl.system.MemoryUtil;

/**
 * The light of a level for every shader that includes {@code surface-light.glsl}: its defines, numbers and textures.
 * Positions are relative to the {@link #anchor}, so they do not depend on the eye.
 */
public final class SurfaceLight {
    public static final SharedResource<SurfaceLight> RESOURCE = SharedResource.of("surface light", SurfaceLight::of)
            .following((light, frame) -> light.follow(frame.frameState()));

    private final Level level;
    private final Scene scene;
    private final LoadContext context;
    private final RendererClouds clouds;
    private final LightMaps maps;
    private final ShadowSampling sampling;
    private final LightParts parts;
    private final LightBlock block;
    private final AmbientLight sky;
    /** {@code null} without punctual lights. */
    private final PunctualLightTable lights;

    private final BufferTexture lightTexels;
    private final BufferTexture lightGrid;
    private final DynamicShadows dynamicShadows;
    /** The number of spheres that hide ambient light from what is near them. */
    private final int contactSpheres;
    /** {@code null} without such spheres. */
    private final UniformBuffer contact;
    /** {@code null} without lightning. */
    private final FrameLightning flash;

    private Vec3 towardsSun;
    /** The projection of the sun's shadow map; {@code null} without a sun that casts shadows. */
    private ShadowFrame sunFrame;

    private Environment followed;
    /** The gains with which the lights were uploaded. */
    private Map<String, Double> gains = Map.of();
    /** {@code null} before the first frame, and without clouds. */
    private CloudInterval cloudsFollowed;
    /** Whether the last frame was lit by a flash. */
    private boolean wasLit;

    private SurfaceLight(LoadContext context) {
        this.context = context;
        scene = context.scene();
        level = scene.level();
        FrameRequest request = context.request();
        GlContext gl = context.gl();
        maps = request.lightMaps();
        clouds = context.get(RendererClouds.RESOURCE);
        flash = context.get(FrameLightning.RESOURCE);
        block = context.own(new LightBlock(gl, flash != null));
        sampling = request.quality().shadowFilter();
        parts = request.quality().lightParts();
        block.parts(weights(parts));
        sky = context.get(AmbientLight.RESOURCE);
        lights = scene.lights() == null
                ? null
                : scene.lights().withMostShadows(request.quality().lightShadows());
        lightTexels = lights == null
                ? null
                : context.own(BufferTexture.ofFloats(gl, "punctual lights", lights.packed(anchor(), gains)));
        lightGrid =
                lights == null ? null : context.own(BufferTexture.ofIntegers(gl, "light grid", lights.packedGrid()));
        dynamicShadows = context.own(new DynamicShadows(gl, maps));
        contactSpheres = request.drawsContact() ? ContactCasters.spheres(level, request.character()) : 0;
        contact = contactSpheres == 0 ? null : context.own(new UniformBuffer(gl, "contact shadow", 8 * contactSpheres));
    }

    private static SurfaceLight of(LoadContext context) {
        SurfaceLight light = new SurfaceLight(context);
        light.follow(FrameState.atStart(context.scene().level()));
        return light;
    }

    private static Vec3 weights(LightParts drawn) {
        return switch (drawn) {
            case ALL -> new Vec3(1, 1, 1);
            case AMBIENT -> new Vec3(1, 0, 0);
            case DIFFUSE -> new Vec3(0, 1, 0);
            case SPECULAR -> new Vec3(0, 0, 1);
        };
    }

    /**
     * Updates the numbers to the current environment, if it has changed.
     *
     * @param state its environment has a sun, sky or constant only if the level has
     */
    private void follow(FrameState state) {
        followGains(state.layerGains());
        Environment now = state.environment();
        CloudInterval interval = clouds.current().now();
        boolean isSame = interval == null
                || cloudsFollowed != null
                        && interval.from() == cloudsFollowed.from()
                        && interval.fraction() == cloudsFollowed.fraction();
        if (now == followed && isSame) {
            followFlash();
            return;
        }
        putFlash();
        if (LightRequirements.sun(level)) {
            putSun(Daylight.onGround(now));
        }
        if (lights != null) {
            block.lightGrid(lights.grid(), anchor());
        }
        if (now.ambient() != null) {
            block.ambient(now.ambient());
        }
        if (LightRequirements.skyShines(level)
                && (!isSame || followed == null || !sky.causes(now).equals(sky.causes(followed)))) {
            block.sky(sky.irradiance(now));
        }
        block.upload();
        followed = now;
        cloudsFollowed = interval;
    }

    private void followGains(Map<String, Double> now) {
        if (lights != null && !now.equals(gains)) {
            gains = now;
            float[] packed = lights.packed(anchor(), gains);
            FloatBuffer texels = MemoryUtil.memAllocFloat(packed.length);
            lightTexels.upload(texels.put(packed).flip());
            MemoryUtil.memFree(texels);
        }
    }

    private void putSun(Sun sun) {
        block.sun(sun);
        if (maps.has(Target.CLOUD_SHADE)) {
            block.cloudShade(FrameClouds.shadeRegion(scene.statics()).moved(anchor().negated()));
        }
        boolean isTurned = !sun.directionTowardsSun().equals(towardsSun);
        towardsSun = sun.directionTowardsSun();
        if (maps.has(Target.SUN_SHADOW)) {
            sunFrame = isTurned ? fitted() : sunFrame;
            block.sunShadow(sunFrame);
        }
    }

    /** Returns a projection that holds everything that casts a shadow of the sun. */
    private ShadowFrame fitted() {
        StaticShapes statics = scene.statics();
        List<Vec3> corners = new ArrayList<>(ShadowCasters.corners(statics, towardsSun));
        corners.addAll(PlantedBillboards.reach(level, statics));
        corners.addAll(PlantedModels.reach(statics));
        if (corners.isEmpty()) {
            // The frame plan is made from the level alone, which does not tell that all meshes are empty.
            corners = List.of(anchor());
        }
        return ShadowFrame.fit(corners, towardsSun, anchor(), context.quality().shadowTexels());
    }

    private void followFlash() {
        if (flash != null && (wasLit || flash.isLit())) {
            putFlash();
            block.upload();
        }
    }

    private void putFlash() {
        if (flash != null) {
            block.flash(flash, anchor());
            wasLit = flash.isLit();
        }
    }

    /** Returns the world position that is the origin of positions in light shaders. */
    public Vec3 anchor() {
        boolean isBare = scene.solids().isEmpty() && scene.statics().ground().isEmpty();
        return isBare ? Vec3.ZERO : scene.solids().origin();
    }

    /** Returns the shadows of dynamic objects. */
    public DynamicShadows dynamicShadows() {
        return dynamicShadows;
    }

    /** Returns the number of spheres that hide ambient light; 0 if nothing does. */
    public int contactSpheres() {
        return contactSpheres;
    }

    /** Sets the spheres that hide ambient light, as {@link ContactCasters#choose} packs them. */
    public void contact(float[] spheres) {
        contact.upload(spheres);
    }

    /** Returns the direction towards the sun, or towards the moon when that is the level's directional light. */
    public Vec3 towardsSun() {
        return towardsSun;
    }

    /** Returns the map's projection for the current sun; {@code null} without a sun that casts shadows. */
    public ShadowFrame sunFrame() {
        return sunFrame;
    }

    /** Returns {@code null} without punctual lights. */
    public PunctualLightTable lights() {
        return lights;
    }

    /** Returns true if light varies over a static face. */
    public boolean variesOverFaces() {
        return needsPositions() || maps.solids().has(Target.SKY_VISIBILITY) || maps.bakes(Baked.BOUNCED);
    }

    /** Returns true if shaders of static surfaces need positions in the level. */
    public boolean needsPositions() {
        return maps.ground().has(Target.SUN_SHADOW)
                || maps.ground().has(Target.CLOUD_SHADE)
                || lights != null && !maps.bakes(Baked.LAMPS)
                || maps.ground().has(Target.DYNAMIC_SUN_SHADOW)
                || contact != null
                || flash != null;
    }

    /** Adds the defines for solids, whose faces are on the light map. */
    public Defines addTo(Defines defines) {
        boolean hasSky = maps.solids().has(Target.SKY_VISIBILITY);
        return addForMeshes(defines)
                .withIf(hasSky, "SKY_VISIBILITY")
                .withIf(hasSky || maps.bakes(Baked.BOUNCED), "LIGHT_MAP");
    }

    /** Adds the defines for models, whose sky visibility and baked light is that of their vertices. */
    public Defines addForModels(Defines defines) {
        return addForMeshes(defines).withIf(maps.bakes(Baked.BOUNCED), "MODEL_LIGHT");
    }

    private Defines addForMeshes(Defines defines) {
        return addStatic(defines)
                .withIf(needsPositions(), "ANCHOR_POSITION")
                .withIf(maps.solids().has(Target.SKY_VISIBILITY), "SKY_AMBIENT");
    }

    /** Adds the defines for terrains, which have light maps of their own. */
    public Defines addForGround(Defines defines) {
        return addStatic(defines).with("ANCHOR_POSITION").withIf(groundReadsSky(), "SKY_AMBIENT");
    }

    /** Returns true if shaders of terrains read a sky visibility. */
    public boolean groundReadsSky() {
        return LightRequirements.skyShines(level) && (!maps.bakes(Baked.SKY) || flash != null);
    }

    /**
     * Adds the defines for dynamic objects, which have no place in the light map; their sky visibility comes from
     * probes.
     */
    public Defines addForDynamicObjects(Defines defines) {
        return addContact(addLights(defines, maps.dynamicObjects(), Set.of()))
                .with("ANCHOR_POSITION")
                .withIf(LightRequirements.skyShines(level), "SKY_AMBIENT");
    }

    /** Adds the defines for the gun before the eye, on which no dynamic object's shadow falls. */
    public Defines addForGun(Defines defines) {
        return addLights(defines, maps.gun(), Set.of())
                .with("ANCHOR_POSITION")
                .withIf(LightRequirements.skyShines(level), "SKY_AMBIENT");
    }

    /** Adds the define for what has no place in the light map, and is lit by probes or by its own colour of baked light. */
    public Defines addBounced(Defines defines) {
        return defines.withIf(LightRequirements.bounces(scene.light()), "BOUNCED_LIGHT");
    }

    private Defines addStatic(Defines defines) {
        Defines live = addContact(addLights(defines, maps.ground(), maps.baked()));
        return maps.bakes(Baked.BOUNCED)
                ? live.with("BAKED_LIGHT")
                        .with("LIGHT_LAYERS", maps.layers())
                        .withIf(maps.bakes(Baked.DIRECTIONS), "LIGHT_DIRECTIONS")
                        .withIf(maps.bakes(Baked.MIRRORED), "MIRRORED_LIGHT")
                        .withIf(maps.bakes(Baked.SKY), "SKY_BAKED")
                : live;
    }

    private Defines addContact(Defines defines) {
        return contact == null ? defines : defines.with("CONTACT").with("CONTACT_SPHERES", contactSpheres);
    }

    /** @param baked the light that is not drawn live */
    private Defines addLights(Defines defines, TargetReads reads, Set<Baked> baked) {
        return defines.withIf(LightRequirements.sun(level) && !baked.contains(Baked.SUN), "SUN")
                .withIf(reads.has(Target.SUN_SHADOW), "SUN_SHADOW")
                .withIf(reads.has(Target.DYNAMIC_SUN_SHADOW), "DYNAMIC_SUN_SHADOW")
                .withIf(reads.has(Target.DYNAMIC_LIGHT_SHADOW), "DYNAMIC_LIGHT_SHADOW")
                .withIf(reads.has(Target.CLOUD_SHADE), "CLOUD_SHADE")
                .withIf(lights != null && !baked.contains(Baked.LAMPS), "PUNCTUAL_LIGHTS")
                .withIf(reads.has(Target.LIGHT_SHADOW), "LIGHT_SHADOW")
                .withIf(flash != null, "FLASH")
                .withIf(parts != LightParts.ALL, "LIGHT_PARTS")
                .withIf(sampling == ShadowSampling.NEAREST, "NEAREST_SHADOW")
                .withIf(level.environment().ambient() != null, "AMBIENT_CONSTANT");
    }

    /**
     * Binds the textures of a program compiled with one of the sets of defines.
     *
     * @param reads those of {@link LightMaps} that the pass declares
     */
    public void bind(TargetReads reads) {
        reads.bind(context.targets());
        block.bind();
        if (lights != null) {
            lightTexels.bind(TextureUnit.PUNCTUAL_LIGHTS);
            lightGrid.bind(TextureUnit.LIGHT_GRID);
        }
        dynamicShadows.bind();
        if (contact != null) {
            contact.bind(UniformBlock.CONTACT);
        }
    }
}
