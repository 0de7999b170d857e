package nephele.app.command;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import nephele.engine.sim.state.Assist;
import nephele.host.terminal.CommandFailure;

/** Parses the assists named on the command line. */
final class AssistNames {
    private static final String NONE = "none";

    private AssistNames() {}

    /** @param names {@code null} for the default */
    static List<Assist> parse(List<String> names) {
        if (names == null) {
            return Assist.USUAL;
        }
        List<Assist> assists = new ArrayList<>();
        for (String name : names) {
            if (!name.equals(NONE)) {
                assists.add(parse(name));
            } else if (names.size() > 1) {
                throw CommandFailure.usage("--assist none stands alone");
            }
        }
        return assists;
    }

    private static Assist parse(String name) {
        return Arrays.stream(Assist.values())
                .filter(assist -> assist.text().equals(name))
                .findFirst()
                .orElseThrow(() -> CommandFailure.usage("--assist " + name + ": there is "
                        + Arrays.stream(Assist.values()).map(Assist::text).collect(Collectors.joining(", "))
                        + " and none"));
    }
}
