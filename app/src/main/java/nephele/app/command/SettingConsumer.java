package nephele.app.command;

import java.util.Map;
import java.util.Stack;
import java.util.regex.Pattern;
import picocli.CommandLine.IParameterConsumer;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

/** Parses `--set key=value …`: it consumes all following words of this form, so that a level may follow. */
final class SettingConsumer implements IParameterConsumer {
    private static final Pattern SETTING = Pattern.compile("([A-Za-z][A-Za-z0-9.]*)=(.*)");

    @Override
    public void consumeParameters(Stack<String> words, ArgSpec option, CommandSpec command) {
        Map<String, String> settings = option.getValue();
        if (words.isEmpty() || !SETTING.matcher(words.peek()).matches()) {
            var found = words.isEmpty() ? "nothing" : "'" + words.peek() + "'";
            throw new ParameterException(command.commandLine(), "--set needs key=value, not " + found);
        }
        while (!words.isEmpty()) {
            var setting = SETTING.matcher(words.peek());
            if (!setting.matches()) {
                return;
            }
            words.pop();
            if (settings.put(setting.group(1), setting.group(2)) != null) {
                throw new ParameterException(command.commandLine(), "--set gives " + setting.group(1) + " twice");
            }
        }
    }
}
