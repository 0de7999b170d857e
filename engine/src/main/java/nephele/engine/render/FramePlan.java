package nephele.engine.render;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;
import nephele.engine.render.pass.shadow.ThingShadowPass;
import nephele.engine.render.pass.thing.HeldPass;
import nephele.engine.render.pass.thing.ThingPass;
import nephele.engine.render.pass.tonemap.ToneMapPass;
import nephele.engine.scene.thing.FigurePresence;

/** Which passes a level requires, in frame order, and why. */
public record FramePlan(List<Step> steps) {
    /** One registered feature; {@code required} is empty when nothing asks for it. */
    public record Step(RenderFeature feature, List<Required> required) {}

    public static FramePlan forLevel(Level level, Output output) {
        return forLevel(level, output, FigurePresence.NEVER);
    }

    public static FramePlan forLevel(Level level, Output output, FigurePresence figure) {
        return forLevel(level, output, figure, RenderFeatures.ALL);
    }

    /** As if no other feature were registered than these. */
    static FramePlan forLevel(Level level, Output output, FigurePresence figure, List<RenderFeature> features) {
        List<Step> steps = new ArrayList<>();
        for (RenderFeature feature : features) {
            List<Required> required = new ArrayList<>(feature.requiredBy().apply(level));
            if (feature == ToneMapPass.FEATURE && output == Output.HDR && required.isEmpty()) {
                required.add(ToneMapPass.FOR_OUTPUT_HDR);
            }
            if (feature == ThingPass.FEATURE && figure == FigurePresence.POSSIBLE && required.isEmpty()) {
                required.add(ThingPass.forFigure(level));
            }
            if (feature == ThingShadowPass.FEATURE && figure == FigurePresence.POSSIBLE && required.isEmpty()) {
                required.addAll(ThingShadowPass.forFigure(level));
            }
            if (feature == HeldPass.FEATURE && figure == FigurePresence.POSSIBLE) {
                required.addAll(HeldPass.forHands(level));
            }
            steps.add(new Step(feature, List.copyOf(required)));
        }
        return new FramePlan(List.copyOf(steps));
    }

    /** What builds the frame's passes, in order. */
    public List<Required> required() {
        return steps.stream().flatMap(step -> step.required().stream()).toList();
    }

    /** {@code NAME: required by JSON.PATH: because} or {@code NAME: not required}, a line for each feature. */
    public List<String> explain() {
        return steps.stream().flatMap(step -> lines(step).stream()).toList();
    }

    private static List<String> lines(Step step) {
        String name = step.feature().name();
        return step.required().isEmpty()
                ? List.of(name + ": not required")
                : step.required().stream()
                        .map(required -> name + ": required by " + required.because())
                        .toList();
    }
}
