package nephele.engine.render;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.Required;

/** Which passes a request requires, in frame order, and why. */
public record FramePlan(List<Step> steps) {
    /** One registered feature; {@code required} is empty when nothing asks for it. */
    public record Step(RenderFeature feature, List<Required> required) {}

    public static FramePlan of(FrameRequest request) {
        return of(request, RenderFeatures.ALL);
    }

    /** As if no other feature were registered than these. */
    static FramePlan of(FrameRequest request, List<RenderFeature> features) {
        List<Step> steps = new ArrayList<>();
        for (RenderFeature feature : features) {
            steps.add(new Step(feature, feature.requiredBy().apply(request)));
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
