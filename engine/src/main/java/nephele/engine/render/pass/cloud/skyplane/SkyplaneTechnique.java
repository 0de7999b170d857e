package nephele.engine.render.pass.cloud.skyplane;

import nephele.engine.level.CloudTechnique;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.pass.cloud.CloudContext;
import nephele.engine.render.pass.cloud.CloudDrawing;
import nephele.engine.render.pass.cloud.CloudPixels;
import nephele.engine.render.pass.cloud.CloudTechniqueDrawer;
import nephele.engine.render.pass.cloud.PlacedCloud;
import nephele.engine.render.pass.cloud.SheetProgram;
import nephele.engine.render.pass.cloud.SheetPrograms;

/** Draws clouds as sheets at the middle of their heights, by the optical depths of their columns. */
public final class SkyplaneTechnique implements CloudTechniqueDrawer {
    public static final Registered REGISTERED =
            new Registered(CloudTechnique.SKYPLANE, cloud -> true, SkyplaneTechnique::new);

    private final CloudContext context;
    private final SheetPrograms<Void> programs;

    private SkyplaneTechnique(CloudContext context) {
        this.context = context;
        programs = new SheetPrograms<>(context, "skyplane", this::compiled);
    }

    @Override
    public CloudDrawing of(PlacedCloud cloud) {
        return new SkyplaneCloud(context.load(), cloud, programs);
    }

    private SheetProgram<Void> compiled(CloudPixels pixels) {
        return new SheetProgram<>(
                context,
                pixels,
                "skyplane/skyplane.frag",
                defines -> defines.with(shapeDefine()),
                SkyplaneTechnique::ownPlaces);
    }

    private String shapeDefine() {
        return "SHEET_" + context.load().quality().skyplaneShape().name();
    }

    private static Void ownPlaces(Uniforms uniforms) {
        uniforms.sampler("sheetColumns", TextureUnit.CLOUD_COLUMNS);
        return null;
    }
}
