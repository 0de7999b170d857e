package nephele.engine.render.pass.cloud.billboard;

import nephele.engine.cloud.drawn.CloudPuffs;
import nephele.engine.cloud.light.BallLight;
import nephele.engine.level.CloudTechnique;
import nephele.engine.render.frame.Quality.BillboardFacing;
import nephele.engine.render.pass.cloud.CloudContext;
import nephele.engine.render.pass.cloud.CloudTechniqueDrawer;
import nephele.engine.render.pass.cloud.CloudTechniqueDrawer.Registered;
import nephele.engine.render.pass.cloud.PixelUniforms;
import nephele.engine.render.pass.cloud.PuffClouds;
import nephele.engine.render.pass.cloud.PuffProgram;

/** Draws each ball of a cloud as a flat picture that is turned towards the eye, with light that is linear across it. */
public final class BillboardTechnique {
    public static final Registered REGISTERED =
            new Registered(CloudTechnique.BILLBOARD, CloudPuffs::canShow, BillboardTechnique::drawer);

    private static final String SHADERS = "/nephele/engine/render/pass/cloud/billboard/billboard";

    private BillboardTechnique() {}

    private static CloudTechniqueDrawer drawer(CloudContext context) {
        BillboardFacing facing = context.load().quality().billboardFacing();
        // What is turned as the screen has no picture that stays right while the view turns.
        return new PuffClouds(
                facing == BillboardFacing.SCREEN ? context.withoutImpostors() : context,
                pixels -> new PuffProgram(
                        context,
                        pixels,
                        SHADERS,
                        BallLight.TAIL,
                        PixelUniforms.defines(context, pixels).with("FACING", facing.ordinal())));
    }
}
