package nephele.engine.render.pass.cloud.particle;

import nephele.engine.cloud.drawn.CloudPuffs;
import nephele.engine.cloud.light.BallLight;
import nephele.engine.level.CloudTechnique;
import nephele.engine.render.pass.cloud.CloudContext;
import nephele.engine.render.pass.cloud.CloudTechniqueDrawer;
import nephele.engine.render.pass.cloud.CloudTechniqueDrawer.Registered;
import nephele.engine.render.pass.cloud.PixelUniforms;
import nephele.engine.render.pass.cloud.PuffClouds;
import nephele.engine.render.pass.cloud.PuffProgram;

/** Blends soft balls whose optical depth along each ray has a closed form. */
public final class ParticleTechnique {
    public static final Registered REGISTERED =
            new Registered(CloudTechnique.PARTICLES, CloudPuffs::canShow, ParticleTechnique::drawer);

    private static final String SHADERS = "/nephele/engine/render/pass/cloud/particle/particle";

    private ParticleTechnique() {}

    private static CloudTechniqueDrawer drawer(CloudContext context) {
        BallLight light = context.load().quality().particleLight();
        return new PuffClouds(
                context,
                pixels -> new PuffProgram(context, pixels, SHADERS, light, PixelUniforms.defines(context, pixels)));
    }
}
