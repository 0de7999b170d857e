package nephele.engine.render.pass.cloud.billboard;

import nephele.engine.cloud.drawn.CloudPuffs;
import nephele.engine.level.CloudTechnique;
import nephele.engine.render.frame.Quality.BillboardFacing;
import nephele.engine.render.frame.Quality.PuffLight;
import nephele.engine.render.pass.cloud.CloudContext;
import nephele.engine.render.pass.cloud.CloudDrawing;
import nephele.engine.render.pass.cloud.CloudDrawing.Technique;
import nephele.engine.render.pass.cloud.PlacedCloud;
import nephele.engine.render.pass.cloud.PuffCloud;

/** Draws each puff of a cloud as a flat picture that is turned towards the eye, with light that is linear across it. */
public final class BillboardTechnique {
    public static final Technique REGISTERED =
            new Technique(CloudTechnique.BILLBOARD, CloudPuffs::canShow, BillboardTechnique::drawing);

    private BillboardTechnique() {}

    private static CloudDrawing drawing(CloudContext context, PlacedCloud cloud) {
        BillboardFacing facing = context.load().quality().billboardFacing();
        // What is turned as the screen has no picture that stays right while the view turns.
        return new PuffCloud(
                facing == BillboardFacing.SCREEN ? context.withoutImpostors() : context,
                cloud,
                "billboard/billboard",
                PuffLight.TAIL,
                defines -> defines.with("FACING", facing.ordinal()));
    }
}
