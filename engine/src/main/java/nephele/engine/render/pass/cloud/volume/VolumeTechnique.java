package nephele.engine.render.pass.cloud.volume;

import nephele.engine.level.CloudTechnique;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.pass.cloud.CloudContext;
import nephele.engine.render.pass.cloud.CloudDrawing;
import nephele.engine.render.pass.cloud.CloudTechniqueDrawer;
import nephele.engine.render.pass.cloud.PerPixels;
import nephele.engine.render.pass.cloud.PlacedCloud;

/** Marches rays through the cells of clouds. */
public final class VolumeTechnique implements CloudTechniqueDrawer {
    public static final Registered REGISTERED =
            new Registered(CloudTechnique.VOLUME, cloud -> true, VolumeTechnique::new);

    private final CloudContext context;
    private final FullScreenTriangle triangle;
    private final PerPixels<MarchPrograms> programs;

    private VolumeTechnique(CloudContext context) {
        this.context = context;
        triangle = context.load().own(new FullScreenTriangle(context.load().gl(), "volume"));
        programs = new PerPixels<>(pixels -> new MarchPrograms(context, pixels));
    }

    @Override
    public CloudDrawing of(PlacedCloud cloud) {
        return new MarchedCloud(context.load(), cloud, programs, triangle);
    }
}
