package nephele.engine.level.layout;

import java.util.List;
import nephele.engine.level.placed.PlacedRule;

/**
 * The rules on the layout of shapes, in the order in which their problems are reported; only starts below
 * the ground and too many kinds of impostors are errors.
 */
public final class LayoutRules {
    public static final List<PlacedRule> ALL = List.of(
            BrushRules.THICK,
            BrushRules.IN_SIGHT,
            FaceRules.APART,
            BuriedRules.LIGHTS,
            Leak.CLOSED,
            GroundRules.ABOVE,
            ImpostorCost.FEW);

    private LayoutRules() {}
}
