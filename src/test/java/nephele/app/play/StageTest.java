package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class StageTest {
    @Test
    void aNormalEveningIsAllowed() {
        var machine = new StageMachine();
        for (var stage : new Stage[] {
            Stage.STARTING,
            Stage.RUNNING,
            Stage.RESTARTING,
            Stage.RUNNING,
            Stage.MENU,
            Stage.RUNNING,
            Stage.MENU,
            Stage.STARTING,
            Stage.RUNNING,
            Stage.LEAVING
        }) {
            machine.change(stage);
            assertTrue(machine.in(stage));
        }
    }

    @ParameterizedTest
    @EnumSource(Stage.class)
    void whatTheTableLacksIsRefusedAndChangesNothing(Stage from) {
        for (var to : EnumSet.complementOf(EnumSet.copyOf(withSelf(from)))) {
            var machine = reached(from);
            assertThrows(IllegalStateException.class, () -> machine.change(to), from + " to " + to);
            assertEquals(from, machine.current());
        }
    }

    @ParameterizedTest
    @EnumSource(Stage.class)
    void everyStageCanLeaveAndNoneFollowsItself(Stage stage) {
        assertEquals(stage != Stage.LEAVING, stage.next().contains(Stage.LEAVING));
        assertFalse(stage.next().contains(stage));
    }

    @Test
    void nothingReturnsToTheBeginning() {
        for (var stage : Stage.values()) {
            assertFalse(stage.next().contains(Stage.INITIALISING));
        }
    }

    private static EnumSet<Stage> withSelf(Stage stage) {
        var allowed = EnumSet.of(stage);
        allowed.addAll(stage.next());
        allowed.remove(stage);
        return allowed.isEmpty() ? EnumSet.of(stage) : allowed;
    }

    private static StageMachine reached(Stage stage) {
        var machine = new StageMachine();
        var way =
                switch (stage) {
                    case INITIALISING -> new Stage[0];
                    case RUNNING -> new Stage[] {Stage.STARTING, Stage.RUNNING};
                    case RESTARTING -> new Stage[] {Stage.STARTING, Stage.RUNNING, Stage.RESTARTING};
                    case MENU, STARTING, LEAVING -> new Stage[] {stage};
                };
        for (var step : way) {
            machine.change(step);
        }
        return machine;
    }
}
