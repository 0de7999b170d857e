package nephele.engine.render.pass.cloud.skybox;

import nephele.engine.level.CloudTechnique;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.pass.cloud.CloudContext;
import nephele.engine.render.pass.cloud.CloudDrawing;
import nephele.engine.render.pass.cloud.CloudTechniqueDrawer;
import nephele.engine.render.pass.cloud.PerPixels;
import nephele.engine.render.pass.cloud.PlacedCloud;

/** Shows pictures of clouds that another technique has drawn from one point, in the direction of each ray. */
public final class SkyboxTechnique implements CloudTechniqueDrawer {
    private final LoadContext load;
    private final CloudTechniqueDrawer baking;
    private final PerPixels<SkyboxProgram> programs;
    private final FullScreenTriangle triangle;

    private SkyboxTechnique(CloudContext context, CloudTechniqueDrawer baking) {
        load = context.load();
        this.baking = baking;
        programs = new PerPixels<>(pixels -> new SkyboxProgram(context, pixels));
        triangle = load.own(new FullScreenTriangle(load.gl(), "skybox of clouds"));
    }

    /** @param baked the technique that draws the pictures */
    public static Registered registered(Registered baked) {
        return new Registered(
                CloudTechnique.SKYBOX,
                baked.canShow(),
                context -> new SkyboxTechnique(context, baked.build().apply(context)));
    }

    @Override
    public CloudDrawing of(PlacedCloud cloud) {
        PlacedCloud still = cloud.again();
        Vec3 bakePoint = BakePoint.of(
                load.scene().level(),
                load.drawn().eyes(),
                cloud.source().bounds());
        var baker = new SkyBaker(load, still, baking.of(still), bakePoint);
        return new SkyboxCloud(load, cloud, baker, programs, triangle);
    }
}
