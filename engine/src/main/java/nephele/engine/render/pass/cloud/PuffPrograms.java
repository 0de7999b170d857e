package nephele.engine.render.pass.cloud;

import java.util.EnumMap;
import java.util.Map;
import java.util.function.Function;

/** A technique that divides clouds into balls: one program for each kind of pixels, compiled when it is first needed. */
public final class PuffPrograms implements CloudTechniqueDrawer {
    private final CloudContext context;
    private final Function<CloudPixels, PuffProgram> compile;
    private final Map<CloudPixels, PuffProgram> programs = new EnumMap<>(CloudPixels.class);

    public PuffPrograms(CloudContext context, Function<CloudPixels, PuffProgram> compile) {
        this.context = context;
        this.compile = compile;
    }

    @Override
    public CloudDrawing of(PlacedCloud cloud) {
        return new PuffCloud(context.load(), cloud, this::program);
    }

    private PuffProgram program(CloudPixels pixels) {
        PuffProgram known = programs.get(pixels);
        if (known == null) {
            known = compile.apply(pixels);
            programs.put(pixels, known);
        }
        return known;
    }
}
