package nephele.engine.render.resource;

import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.Target;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Sun;
import nephele.engine.level.billboard.PlantedBillboards;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.level.planted.PlantedModels;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.ShadowCasters;
import nephele.engine.scene.light.ShadowFrame;

/** The sun's part of {@code surface-light.glsl}, with the shadows of static geometry. */
final class SunLight {
    private final FrameRequest request;
    private final StaticShapes statics;
    private final Vec3 anchor;
    private Vec3 towardsSun;
    private ShadowFrame frame;

    /**
     * @param statics the level's shapes
     * @param anchor the origin of positions in shaders
     */
    SunLight(FrameRequest request, StaticShapes statics, Vec3 anchor) {
        this.request = request;
        this.statics = statics;
        this.anchor = anchor;
    }

    boolean shines() {
        return LightRequirements.sun(request.level());
    }

    boolean hasShadow() {
        return request.lightMaps().has(Target.SUN_SHADOW);
    }

    boolean hasCloudShade() {
        return request.lightMaps().has(Target.CLOUD_SHADE);
    }

    void put(Sun sun, LightBlock block) {
        if (!shines()) {
            return;
        }
        block.sun(sun);
        if (hasCloudShade()) {
            block.cloudShade(CloudShadeRegion.of(statics).moved(anchor.negated()));
        }
        boolean isTurned = !sun.directionTowardsSun().equals(towardsSun);
        towardsSun = sun.directionTowardsSun();
        if (hasShadow()) {
            frame = isTurned ? fitted() : frame;
            block.sunShadow(frame);
        }
    }

    Vec3 towardsSun() {
        return towardsSun;
    }

    private ShadowFrame fitted() {
        List<Vec3> corners = new ArrayList<>(ShadowCasters.corners(statics, towardsSun));
        corners.addAll(PlantedBillboards.reach(request.level(), statics));
        corners.addAll(PlantedModels.reach(statics));
        if (corners.isEmpty()) {
            // The frame plan is made from the level alone, which does not tell that all meshes are empty.
            corners = List.of(anchor);
        }
        return ShadowFrame.fit(corners, towardsSun, anchor, request.quality().shadowTexels());
    }

    /** Returns the projection for the current sun; {@code null} without a sun that casts shadows. */
    ShadowFrame frame() {
        return frame;
    }

    Defines addTo(Defines defines) {
        return defines.withIf(shines(), "SUN").withIf(hasShadow(), "SUN_SHADOW").withIf(hasCloudShade(), "CLOUD_SHADE");
    }

    void tie(Uniforms uniforms) {
        if (hasShadow()) {
            uniforms.sampler("sunShadowMap", TextureUnit.SUN_SHADOW);
        }
        if (hasCloudShade()) {
            uniforms.sampler("cloudShade", TextureUnit.CLOUD_SHADE);
        }
    }
}
