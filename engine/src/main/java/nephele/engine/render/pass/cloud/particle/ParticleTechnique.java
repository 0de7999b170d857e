package nephele.engine.render.pass.cloud.particle;

import java.util.EnumMap;
import java.util.Map;
import nephele.engine.cloud.drawn.CloudPuffs;
import nephele.engine.level.CloudTechnique;
import nephele.engine.render.pass.cloud.CloudContext;
import nephele.engine.render.pass.cloud.CloudDrawing;
import nephele.engine.render.pass.cloud.CloudPixels;
import nephele.engine.render.pass.cloud.CloudTechniqueDrawer;
import nephele.engine.render.pass.cloud.PlacedCloud;

/** Blends soft balls whose optical depth has a closed form. */
public final class ParticleTechnique implements CloudTechniqueDrawer {
    public static final Registered REGISTERED =
            new Registered(CloudTechnique.PARTICLES, CloudPuffs::canShow, ParticleTechnique::new);

    private final CloudContext context;
    /** Compiled when a cloud first needs them. */
    private final Map<CloudPixels, ParticleProgram> programs = new EnumMap<>(CloudPixels.class);

    private ParticleTechnique(CloudContext context) {
        this.context = context;
    }

    @Override
    public CloudDrawing of(PlacedCloud cloud) {
        return new ParticleCloud(context.load(), cloud, this::program);
    }

    private ParticleProgram program(CloudPixels pixels) {
        ParticleProgram known = programs.get(pixels);
        if (known == null) {
            known = new ParticleProgram(context, pixels);
            programs.put(pixels, known);
        }
        return known;
    }
}
