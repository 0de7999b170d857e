package nephele.host.playthrough;

import nephele.engine.sim.state.PlayerInput;

/** The input of a device without its turns: before a fixed camera, each key always moves in the same direction. */
public record UnturnedInput(TickInput device) implements TickInput {
    @Override
    public PlayerInput next() {
        return device.next().turning(0, 0);
    }

    @Override
    public boolean isFinished() {
        return device.isFinished();
    }
}
