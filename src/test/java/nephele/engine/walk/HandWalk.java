package nephele.engine.walk;

import nephele.engine.level.Level;
import nephele.engine.sim.PlayerInput;
import nephele.engine.sim.SimSettings;

/** A walk in a level whose input the test gives. */
final class HandWalk {
    private final Walk walk;
    private PlayerInput hands = PlayerInput.NONE;

    HandWalk(Level level) {
        walk = new Walk(level, new Walk.Beginning("room.json", SimSettings.DEFAULT, null), new TickInput() {
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

    Walk walk() {
        return walk;
    }

    /** From now on. */
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
