/** {@code sunbeam color}: colors by viewing angle. */
package sunbeam.app.cli.color;
