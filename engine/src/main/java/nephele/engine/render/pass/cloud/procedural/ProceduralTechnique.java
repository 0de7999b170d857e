package nephele.engine.render.pass.cloud.procedural;

import nephele.engine.level.CloudTechnique;
import nephele.engine.render.pass.cloud.CloudContext;
import nephele.engine.render.pass.cloud.CloudDrawing;
import nephele.engine.render.pass.cloud.CloudPixels;
import nephele.engine.render.pass.cloud.CloudTechniqueDrawer;
import nephele.engine.render.pass.cloud.PlacedCloud;
import nephele.engine.render.pass.cloud.SheetProgram;
import nephele.engine.render.pass.cloud.SheetPrograms;

/** Draws clouds as sheets whose optical depth is computed from octaves of noise in the shader. */
public final class ProceduralTechnique implements CloudTechniqueDrawer {
    public static final Registered REGISTERED =
            new Registered(CloudTechnique.PROCEDURAL, cloud -> true, ProceduralTechnique::new);

    private final CloudContext context;
    private final SheetPrograms<OctaveUniforms> programs;

    private ProceduralTechnique(CloudContext context) {
        this.context = context;
        programs = new SheetPrograms<>(context, "procedural", this::compiled);
    }

    @Override
    public CloudDrawing of(PlacedCloud cloud) {
        return new ProceduralCloud(context.load(), cloud, programs);
    }

    private SheetProgram<OctaveUniforms> compiled(CloudPixels pixels) {
        boolean isSmooth = context.load().quality().proceduralNoise().isSmooth();
        return new SheetProgram<>(
                context,
                pixels,
                "procedural/procedural.frag",
                defines -> defines.withIf(isSmooth, "SMOOTH"),
                OctaveUniforms::of);
    }
}
