/** Output of commands to the user: text, exit codes, failures in plain words, and crash reports. */
package nephele.host.terminal;
