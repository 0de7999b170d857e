package nephele.engine.render.pass.cloud.procedural;

import java.util.EnumMap;
import java.util.Map;
import nephele.engine.level.CloudTechnique;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.pass.cloud.CloudContext;
import nephele.engine.render.pass.cloud.CloudDrawing;
import nephele.engine.render.pass.cloud.CloudPixels;
import nephele.engine.render.pass.cloud.CloudTechniqueDrawer;
import nephele.engine.render.pass.cloud.PlacedCloud;
import nephele.engine.render.pass.cloud.SheetProgram;

/** Draws clouds as sheets whose optical depth is computed from octaves of noise in the shader. */
public final class ProceduralTechnique implements CloudTechniqueDrawer {
    public static final Registered REGISTERED =
            new Registered(CloudTechnique.PROCEDURAL, cloud -> true, ProceduralTechnique::new);

    private final CloudContext context;
    private final FullScreenTriangle triangle;
    /** Compiled when a cloud first needs them. */
    private final Map<CloudPixels, SheetProgram<OctaveUniforms>> programs = new EnumMap<>(CloudPixels.class);

    private ProceduralTechnique(CloudContext context) {
        this.context = context;
        triangle = context.load().own(new FullScreenTriangle(context.load().gl(), "procedural"));
    }

    @Override
    public CloudDrawing of(PlacedCloud cloud) {
        return new ProceduralCloud(context.load(), cloud, this::program, triangle);
    }

    private SheetProgram<OctaveUniforms> program(CloudPixels pixels) {
        SheetProgram<OctaveUniforms> program = programs.get(pixels);
        if (program == null) {
            boolean isSmooth = context.load().quality().proceduralNoise().isSmooth();
            program = new SheetProgram<>(
                    context,
                    pixels,
                    "procedural/procedural.frag",
                    defines -> defines.withIf(isSmooth, "SMOOTH"),
                    OctaveUniforms::of);
            programs.put(pixels, program);
        }
        return program;
    }
}
