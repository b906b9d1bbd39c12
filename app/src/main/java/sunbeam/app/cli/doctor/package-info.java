/** Command {@code doctor}: checks whether rendering works on this machine. */
package sunbeam.app.cli.doctor;
