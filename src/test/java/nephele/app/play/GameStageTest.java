package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class GameStageTest {
    @Test
    void aNormalEveningIsAllowed() {
        var machine = new StageMachine(null);
        for (var stage : new GameStage[] {
            GameStage.STARTING,
            GameStage.RUNNING,
            GameStage.RESTARTING,
            GameStage.RUNNING,
            GameStage.MENU,
            GameStage.RUNNING,
            GameStage.MENU,
            GameStage.STARTING,
            GameStage.RUNNING,
            GameStage.ENDED,
            GameStage.STARTING,
            GameStage.RUNNING,
            GameStage.MENU,
            GameStage.TITLE,
            GameStage.RESTARTING,
            GameStage.RUNNING,
            GameStage.LEAVING
        }) {
            machine.change(stage);
            assertTrue(machine.in(stage));
        }
    }

    @ParameterizedTest
    @EnumSource(GameStage.class)
    void whatTheTableLacksIsRefusedAndChangesNothing(GameStage from) {
        for (var to : EnumSet.complementOf(EnumSet.copyOf(withSelf(from)))) {
            var machine = reached(from);
            assertThrows(IllegalStateException.class, () -> machine.change(to), from + " to " + to);
            assertEquals(from, machine.current());
        }
    }

    @ParameterizedTest
    @EnumSource(GameStage.class)
    void everyStageCanLeaveAndNoneFollowsItself(GameStage stage) {
        assertEquals(stage != GameStage.LEAVING, stage.next().contains(GameStage.LEAVING));
        assertFalse(stage.next().contains(stage));
    }

    @Test
    void nothingReturnsToTheBeginning() {
        for (var stage : GameStage.values()) {
            assertFalse(stage.next().contains(GameStage.INITIALISING));
        }
    }

    private static EnumSet<GameStage> withSelf(GameStage stage) {
        var allowed = EnumSet.of(stage);
        allowed.addAll(stage.next());
        allowed.remove(stage);
        return allowed.isEmpty() ? EnumSet.of(stage) : allowed;
    }

    private static StageMachine reached(GameStage stage) {
        var machine = new StageMachine(null);
        var way =
                switch (stage) {
                    case INITIALISING -> new GameStage[0];
                    case RUNNING -> new GameStage[] {GameStage.STARTING, GameStage.RUNNING};
                    case RESTARTING -> new GameStage[] {GameStage.STARTING, GameStage.RUNNING, GameStage.RESTARTING};
                    case ENDED -> new GameStage[] {GameStage.STARTING, GameStage.RUNNING, GameStage.ENDED};
                    case TITLE, MENU, STARTING, LEAVING -> new GameStage[] {stage};
                };
        for (var step : way) {
            machine.change(step);
        }
        return machine;
    }
}
