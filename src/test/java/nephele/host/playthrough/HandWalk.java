package nephele.host.playthrough;

import nephele.engine.level.Level;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.SimSettings;

/** A walk in a level with input from the test. */
final class HandWalk {
    private final Playthrough walk;
    private PlayerInput hands = PlayerInput.NONE;

    HandWalk(Level level) {
        this(level, SimSettings.DEFAULT);
    }

    HandWalk(Level level, SimSettings settings) {
        walk = new Playthrough(level, new Playthrough.Beginning("room.json", settings, null), new TickInput() {
            @Override
            public PlayerInput next() {
                return hands;
            }

            @Override
            public boolean isFinished() {
                return false;
            }
        });
    }

    Playthrough walk() {
        return walk;
    }

    /** Sets the input of all later ticks. */
    HandWalk hold(PlayerInput held) {
        hands = held;
        return this;
    }

    HandWalk ticks(int count) {
        for (int i = 0; i < count; i++) {
            walk.tick();
        }
        return this;
    }
}
