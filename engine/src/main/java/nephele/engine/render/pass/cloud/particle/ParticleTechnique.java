package nephele.engine.render.pass.cloud.particle;

import nephele.engine.cloud.drawn.CloudPuffs;
import nephele.engine.level.CloudTechnique;
import nephele.engine.render.pass.cloud.CloudDrawing.Technique;
import nephele.engine.render.pass.cloud.PuffCloud;

/** Blends the puffs of a cloud, whose optical depth along each ray has a closed form. */
public final class ParticleTechnique {
    public static final Technique REGISTERED = new Technique(
            CloudTechnique.PARTICLES,
            CloudPuffs::canShow,
            (context, cloud) -> new PuffCloud(
                    context,
                    cloud,
                    "particle/particle",
                    context.load().quality().particleLight(),
                    defines -> defines));

    private ParticleTechnique() {}
}
