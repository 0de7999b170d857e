package nephele.engine.render.pass.cloud;

import java.util.function.Function;

/** A technique that divides clouds into balls. */
public final class PuffClouds implements CloudTechniqueDrawer {
    private final CloudContext context;
    private final PerPixels<PuffProgram> programs;

    /** @param context without impostors if balls look other as the view turns */
    public PuffClouds(CloudContext context, Function<CloudPixels, PuffProgram> compile) {
        this.context = context;
        programs = new PerPixels<>(compile);
    }

    @Override
    public CloudDrawing of(PlacedCloud cloud) {
        return new PuffCloud(context, cloud, programs);
    }
}
