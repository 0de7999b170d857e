/** What a command tells its user: text, exit codes, failures in plain words and crash reports. */
package nephele.engine.terminal;
