package nephele.engine.render.pass.cloud.skyplane;

import java.util.EnumMap;
import java.util.Map;
import nephele.engine.level.CloudTechnique;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import nephele.engine.render.pass.cloud.CloudContext;
import nephele.engine.render.pass.cloud.CloudDrawing;
import nephele.engine.render.pass.cloud.CloudPixels;
import nephele.engine.render.pass.cloud.CloudTechniqueDrawer;
import nephele.engine.render.pass.cloud.PlacedCloud;
import nephele.engine.render.pass.cloud.SheetProgram;

/** Draws clouds as sheets at the middle of their heights, by the optical depths of their columns. */
public final class SkyplaneTechnique implements CloudTechniqueDrawer {
    public static final Registered REGISTERED =
            new Registered(CloudTechnique.SKYPLANE, cloud -> true, SkyplaneTechnique::new);

    private final CloudContext context;
    private final FullScreenTriangle triangle;
    /** Compiled when a cloud first needs them. */
    private final Map<CloudPixels, SheetProgram<Void>> programs = new EnumMap<>(CloudPixels.class);

    private SkyplaneTechnique(CloudContext context) {
        this.context = context;
        triangle = context.load().own(new FullScreenTriangle(context.load().gl(), "skyplane"));
    }

    @Override
    public CloudDrawing of(PlacedCloud cloud) {
        return new SkyplaneCloud(context.load(), cloud, this::program, triangle);
    }

    private SheetProgram<Void> program(CloudPixels pixels) {
        SheetProgram<Void> program = programs.get(pixels);
        if (program == null) {
            program = new SheetProgram<>(
                    context,
                    pixels,
                    "skyplane/skyplane.frag",
                    defines -> defines.with(shapeDefine()),
                    SkyplaneTechnique::ownPlaces);
            programs.put(pixels, program);
        }
        return program;
    }

    private String shapeDefine() {
        return "SHEET_" + context.load().quality().skyplaneShape().name();
    }

    private static Void ownPlaces(Uniforms uniforms) {
        uniforms.sampler("sheetColumns", TextureUnit.CLOUD_COLUMNS);
        return null;
    }
}
